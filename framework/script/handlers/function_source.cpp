#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include <handlers/function_source.h>
#include <lua/environment.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <sources/sources.h>
#include <text/words.h>

namespace fettle::script {

namespace {

/// Finds the functions in the text of a chunk. It distinguishes only words, strings and comments.
class FunctionFinder {
  public:
    FunctionFinder(std::string_view text, int first_line, int last_line)
        : text_(text), first_line_(first_line), last_line_(last_line) {}

    /// The texts of the functions that begin on the first and end on the last line, without names.
    std::vector<std::string> run() {
        if (text_.starts_with('#')) skip_to(text_.find('\n'));
        while (at_ < text_.size() && line_ <= last_line_) {
            const char c = text_[at_];
            if (c == '-' && text_.substr(at_, 2) == "--") {
                skip_comment();
            } else if (c == '[' && long_bracket(at_) != npos) {
                skip_long(long_bracket(at_));
            } else if (c == '"' || c == '\'') {
                skip_string(c);
            } else if (is_word(c)) {
                word();
            } else {
                skip_to(at_ + 1);
            }
        }
        return std::move(found_);
    }

  private:
    static constexpr std::size_t npos = std::string_view::npos;

    struct Block {
        bool function;
        std::size_t begin;
        int line;
    };

    void skip_to(std::size_t next) {
        next = std::min(next, text_.size());
        line_ +=
            static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                        text_.begin() + static_cast<std::ptrdiff_t>(next), '\n'));
        at_ = next;
    }
    /// Number of equal signs of a bracket `[==[`; npos if there is no such bracket.
    std::size_t long_bracket(std::size_t at) const {
        std::size_t i = at + 1;
        while (i < text_.size() && text_[i] == '=') ++i;
        return i < text_.size() && text_[i] == '[' ? i - at - 1 : npos;
    }
    void skip_long(std::size_t signs) {
        const std::string close = "]" + std::string(signs, '=') + "]";
        const std::size_t end = text_.find(close, at_);
        skip_to(end == npos ? npos : end + close.size());
    }
    void skip_comment() {
        at_ += 2;
        const std::size_t signs =
            at_ < text_.size() && text_[at_] == '[' ? long_bracket(at_) : npos;
        signs == npos ? skip_to(text_.find('\n', at_)) : skip_long(signs);
    }
    void skip_string(char quote) {
        std::size_t i = at_ + 1;
        for (; i < text_.size() && text_[i] != quote && text_[i] != '\n'; ++i) {
            if (text_[i] != '\\') continue;
            ++i;
            if (i >= text_.size() || text_[i] != 'z') continue;
            // It skips the white space after it, also line ends.
            while (i + 1 < text_.size() &&
                   std::isspace(static_cast<unsigned char>(text_[i + 1])) != 0)
                ++i;
        }
        skip_to(i + 1);
    }
    void word() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && is_word(text_[at_])) ++at_;
        const std::string_view word = text_.substr(begin, at_ - begin);
        if (word == "function" || word == "do" || word == "if" || word == "repeat") {
            blocks_.push_back({word == "function", begin, line_});
        } else if ((word == "end" || word == "until") && !blocks_.empty()) {
            const Block block = blocks_.back();
            blocks_.pop_back();
            if (block.function && block.line == first_line_ && line_ == last_line_)
                add(text_.substr(block.begin, at_ - block.begin));
        }
    }
    void add(std::string_view function) {
        const std::size_t parameters = function.find('(');
        if (parameters == npos || function.substr(0, parameters).find(':') != npos) return;
        found_.push_back("function" + std::string(function.substr(parameters)));
    }

    std::string_view text_;
    int first_line_, last_line_;
    std::size_t at_ = 0;
    int line_ = 1;
    std::vector<Block> blocks_;
    std::vector<std::string> found_;
};

int append_piece(lua_State*, const void* piece, std::size_t size, void* out) {
    static_cast<std::string*>(out)->append(static_cast<const char*>(piece), size);
    return 0;
}

/// The bytecode of the function at the top of the stack. It does not depend on the position of the
/// text.
std::string compiled(lua_State* L) {
    std::string bytes;
    lua_dump(L, append_piece, &bytes, 1);
    return bytes;
}

// The bytecode contains the index of the environment among the variables of the enclosing
// functions. This index is not known, so up to this number of preceding variables are tried.
constexpr int max_variables_around = 16;

/// Whether `text`, at its line, compiles to these bytes.
bool compiles_to(lua_State* L, const std::string& text, int line, const std::string& bytes) {
    const std::string above(static_cast<std::size_t>(std::max(line - 1, 0)), '\n');
    std::string variables;
    for (int count = 0; count <= max_variables_around; ++count) {
        std::string chunk = above;
        if (count > 0) {
            variables += (count > 1 ? ",u" : "u") + std::to_string(count);
            chunk += "local " + variables + " return (function() local _ = " + variables;
        }
        chunk += " return " + text + (count > 0 ? " end)()" : "");
        const int top = lua_gettop(L);
        if (load_text(L, chunk, "=text") != LUA_OK) {
            lua_settop(L, top);
            return false;
        }
        lua_call(L, 0, 1);
        const bool same = compiled(L) == bytes;
        lua_settop(L, top);
        if (same) return true;
    }
    return false;
}

/// The names of the outer local variables that the function uses, as a reason why it cannot be
/// saved.
std::string variables_around(lua_State* L, Machine& machine, int index, const std::string& where) {
    std::string names;
    int count = 0;
    for (int i = 1; const char* name = lua_getupvalue(L, index, i); ++i) {
        push_registry(L, machine.globals.table);
        const bool environment = lua_rawequal(L, -1, -2) != 0;
        lua_pop(L, 2);
        if (environment) continue;
        if (std::string_view(name) == "_ENV") return "uses an environment of its own";
        if (++count <= 3) names += (count > 1 ? ", \"" : "\"") + std::string(name) + "\"";
    }
    if (count == 0) return {};
    if (count > 3) names += " and " + std::to_string(count - 3) + " more";
    return "uses the local variable" + std::string(count > 1 ? "s " : " ") + names + " of " + where;
}

}  // namespace

FunctionSource function_source(lua_State* L, Machine& machine, int index) {
    FunctionSource found;
    if (lua_iscfunction(L, index)) return {"", "is built in and has no text"};
    index = lua_absindex(L, index);
    lua_Debug info;
    lua_pushvalue(L, index);
    lua_getinfo(L, ">S", &info);
    const std::string where = std::string(info.short_src) + ":" + std::to_string(info.linedefined);
    found.not_saved = variables_around(L, machine, index, where);
    const std::string name =
        info.source[0] == '@' || info.source[0] == '=' ? info.source + 1 : std::string();
    const auto source = machine.sources.texts.find(name);
    if (source != machine.sources.texts.end()) {
        const bool alone = found.not_saved.empty();
        lua_pushvalue(L, index);
        const std::string bytes = compiled(L);
        lua_pop(L, 1);
        for (std::string& text :
             FunctionFinder(source->second, info.linedefined, info.lastlinedefined).run())
            if (!alone || compiles_to(L, text, info.linedefined, bytes)) {
                found.text = std::move(text);
                break;
            }
    }
    if (found.text.empty() && found.not_saved.empty())
        found.not_saved = "has no text that could be found in " + where;
    return found;
}

bool is_function_text(std::string_view text) {
    constexpr std::string_view word = "function";
    return text.starts_with(word) && (text.size() == word.size() || !is_word(text[word.size()]));
}

}  // namespace fettle::script
