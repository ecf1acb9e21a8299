#include <sources/typed_commands.h>
#include <text/lua_code.h>
#include <text/words.h>

namespace fettle::script {

void TypedCommands::store(std::string_view command, Texts& texts) {
    constexpr std::size_t most = 1000;  // texts that are kept
    texts[plain_chunk] = command;
    chunk_ = plain_chunk;
    const std::string code = code_of(command);
    note_locals(code);
    if (find_word(code, "function") == std::string_view::npos) return;
    if (!kept_.empty() && texts[kept_.back()] == command) {  // as of a key that is held
        chunk_ = kept_.back();
        return;
    }
    chunk_ += " " + std::to_string(++number_);
    texts[chunk_] = command;
    kept_.push_back(chunk_);
    if (kept_.size() <= most) return;
    texts.erase(kept_.front());
    kept_.pop_front();
}

void TypedCommands::name_plainly(ScriptError& error) const {
    if (error.file != chunk_) return;
    error.file = plain_chunk;
    name_plainly(error.message);
    name_plainly(error.traceback);
}

void TypedCommands::name_plainly(std::string& text) const {
    for (std::size_t at = text.find(chunk_ + ":"); at != std::string::npos;
         at = text.find(chunk_ + ":", at + 1))
        text.replace(at, chunk_.size(), plain_chunk);
}

void TypedCommands::note_locals(std::string_view code) {
    constexpr std::string_view word = "local";
    constexpr std::size_t most = 1000;  // names
    for (std::size_t at = find_word(code, word); at != std::string_view::npos;
         at = find_word(code, word, at + 1)) {
        std::size_t begin = at + word.size();
        do {
            begin = code.find_first_not_of(" ,\t\n", begin);
            if (begin == std::string_view::npos || locals_.size() >= most) return;
            std::size_t end = begin;
            while (end < code.size() && is_word(code[end])) ++end;
            const std::string_view name = code.substr(begin, end - begin);
            if (!name.empty() && !is_word_of_lua(name)) locals_.emplace(name);
            begin = code.find_first_not_of(" \t\n", end);
        } while (begin != std::string_view::npos && code[begin] == ',');
    }
}

bool TypedCommands::is_chunk(std::string_view chunk) {
    const std::string_view console = plain_chunk;
    return chunk.starts_with(console) &&
           chunk.find_first_not_of(" 0123456789", console.size()) == std::string_view::npos;
}

}  // namespace fettle::script
