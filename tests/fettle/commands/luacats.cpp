#include "luacats.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <sstream>

namespace luacats {

namespace {

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool is_keyword(const std::string& word) {
    static const std::set<std::string> words = {
        "and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
        "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
        "repeat",   "return", "then", "true", "until",  "while"};
    return words.contains(word);
}

/// Reads along one line; throws Malformed at an unexpected character.
class Line {
  public:
    Line(std::string text, int number, std::set<std::string>& types)
        : text_(std::move(text)), number_(number), types_(types) {}

    [[noreturn]] void fail(const std::string& what) const {
        throw Malformed("line " + std::to_string(number_) + ", column " + std::to_string(at_ + 1) +
                        ": " + what + " in: " + text_);
    }
    bool done() const { return at_ >= text_.size(); }
    char peek() const { return done() ? '\0' : text_[at_]; }
    bool accept(const std::string& token) {
        if (text_.compare(at_, token.size(), token) != 0) return false;
        at_ += token.size();
        return true;
    }
    void expect(const std::string& token) {
        if (!accept(token)) fail("expected '" + token + "'");
    }
    std::string rest() {
        std::string text = text_.substr(at_);
        at_ = text_.size();
        return text;
    }
    /// Reads a description, which must not be empty.
    std::string doc() {
        const std::string text = rest();
        if (text.empty() || text.front() == ' ' || text.back() == ' ') fail("expected a text");
        return text;
    }
    std::string word() {
        const std::size_t start = at_;
        while (is_word(peek())) ++at_;
        if (at_ == start || std::isdigit(static_cast<unsigned char>(text_[start])) != 0)
            fail("expected a name");
        return text_.substr(start, at_ - start);
    }
    std::string dotted() {
        std::string name = word();
        while (accept(".")) name += "." + word();
        return name;
    }

    /// TYPE = part {"|" part}; part = primary {"[]"} ["?"]
    std::string type() {
        const std::size_t start = at_;
        do {
            primary();
            while (accept("[]")) {
            }
            (void)accept("?");
        } while (accept("|"));
        return text_.substr(start, at_ - start);
    }

  private:
    void primary() {
        if (accept("\"")) {
            while (!done() && peek() != '"') ++at_;
            expect("\"");
        } else if (text_.compare(at_, 4, "fun(") == 0) {
            at_ += 4;
            function();
        } else {
            types_.insert(dotted());
            if (!accept("<")) return;
            do type();
            while (accept(", "));
            expect(">");
        }
    }
    void function() {
        bool first = true;
        while (!accept(")")) {
            if (!first) expect(", ");
            first = false;
            if (!accept("...")) (void)word();
            (void)accept("?");
            expect(": ");
            type();
        }
        if (!accept(": ")) return;
        do type();
        while (accept(", "));
    }

    std::string text_;
    int number_;
    std::size_t at_ = 0;
    std::set<std::string>& types_;
};

class Reader {
  public:
    explicit Reader(const std::string& text) : text_(text) {}

    File read() {
        std::istringstream in(text_);
        std::string text;
        for (int number = 1; std::getline(in, text); ++number) {
            Line line(text, number, file_.types);
            if (number == 1) {
                line.expect("---@meta fettle");
            } else if (text.empty()) {
                if (!pending_) continue;
                if (pending_->class_name.empty()) line.fail("a comment that belongs to nothing");
                (void)define_class(line);  // a class without a table
            } else {
                read(line);
            }
            if (!line.done() && !text.empty()) line.fail("unexpected text");
        }
        return std::move(file_);
    }

  private:
    struct Pending {
        std::string doc, type, class_name;
        Function function;
        Class class_info;
    };
    Pending& pending() {
        if (!pending_) pending_.emplace();
        return *pending_;
    }

    void read(Line& line) {
        if (line.accept("---@")) {
            tag(line);
        } else if (line.accept("---")) {
            if (!pending().doc.empty()) line.fail("a second doc text");
            pending().doc = line.doc();
        } else if (line.accept("-- ")) {
            (void)line.doc();
        } else if (line.accept("function ")) {
            function(line);
        } else if (line.accept("local ")) {
            const std::string name = line.word();
            line.expect(" = {}");
            locals_[name] = define_class(line);
        } else {
            variable(line);
        }
    }

    void tag(Line& line) {
        const std::string name = line.word();
        if (!line.done()) line.expect(" ");
        Pending& p = pending();
        if (name == "class") {
            p.class_name = line.dotted();
            if (line.accept(" : ")) file_.types.insert(p.class_info.base = line.dotted());
        } else if (name == "field") {
            field(line, p);
        } else if (name == "operator") {
            std::string operation = line.word();
            if (line.accept("(")) {
                operation += "(" + line.type() + ")";
                line.expect(")");
            }
            line.expect(": ");
            (void)line.type();
            p.class_info.operators.push_back(operation);
        } else if (name == "overload") {
            const std::string type = line.type();
            if (!type.starts_with("fun(")) line.fail("an overload is a function");
            (p.class_name.empty() ? p.function.overloads : p.class_info.overloads).push_back(type);
        } else if (name == "param") {
            parameter(line, p);
        } else if (name == "return") {
            Field result{line.type(), ""};
            if (line.accept(" ")) {
                (void)line.word();
                line.expect(" ");
                result.doc = line.doc();
            }
            p.function.returns.push_back(result);
        } else if (name == "type") {
            p.type = line.type();
        } else {
            line.fail("unknown tag");
        }
    }

    void field(Line& line, Pending& p) {
        std::string name;
        if (line.accept("[\"")) {
            while (is_word(line.peek())) name += line.peek(), line.expect({line.peek()});
            line.expect("\"]");
        } else if (line.accept("[")) {
            name = "[" + line.type() + "]";
            line.expect("]");
        } else {
            name = line.word();
            if (is_keyword(name)) line.fail("a keyword needs brackets");
        }
        line.expect(" ");
        Field field{line.type(), ""};
        line.expect(" ");
        field.doc = line.doc();
        if (p.class_name.empty()) line.fail("a field without a class");
        if (!p.class_info.fields.emplace(name, field).second) line.fail("the field is there twice");
    }

    void parameter(Line& line, Pending& p) {
        Parameter parameter;
        parameter.name = line.accept("...") ? "..." : line.word();
        parameter.optional = line.accept("?");
        line.expect(" ");
        parameter.type = line.type();
        if (line.accept(" ")) parameter.doc = line.doc();
        if (is_keyword(parameter.name)) line.fail("a keyword cannot name a parameter");
        p.function.parameters.push_back(parameter);
    }

    std::string define_class(Line& line) {
        if (!pending_ || pending_->class_name.empty()) line.fail("a table without a class");
        Pending p = std::move(*pending_);
        pending_.reset();
        p.class_info.doc = p.doc;
        if (p.doc.empty()) line.fail("a class without a doc text");
        if (!file_.classes.emplace(p.class_name, p.class_info).second)
            line.fail("the class is there twice");
        return p.class_name;
    }

    void function(Line& line) {
        std::string name = line.dotted(), owner;
        const std::size_t dot = name.rfind('.');
        if (line.accept(":")) {
            owner = name;
            name = line.word();
        } else if (dot != std::string::npos && locals_.contains(name.substr(0, dot))) {
            owner = name.substr(0, dot);
            name = name.substr(dot + 1);
        }
        line.expect("(");
        if (!pending_ || pending_->doc.empty()) line.fail("a function without a doc text");
        bool first = true;
        for (const Parameter& parameter : pending_->function.parameters) {
            if (!first) line.expect(", ");
            first = false;
            line.expect(parameter.name);
        }
        line.expect(") end");
        Function function = std::move(pending_->function);
        function.doc = pending_->doc;
        pending_.reset();
        if (!owner.empty() && !locals_.contains(owner)) line.fail("of a table that is not there");
        auto& functions =
            owner.empty() ? file_.functions : file_.classes.at(locals_.at(owner)).methods;
        if (!functions.emplace(name, function).second) line.fail("the function is there twice");
    }

    void variable(Line& line) {
        const std::string name = line.dotted();
        line.expect(" = ");
        if (line.accept("{}")) {
            if (!pending_) {  // a library
                file_.variables.emplace(name, Field{"table", "A library."});
                return;
            }
            file_.variables.emplace(name, Field{pending_->class_name, pending_->doc});
            (void)define_class(line);
            return;
        }
        line.expect("nil");
        if (!pending_ || pending_->type.empty() || pending_->doc.empty())
            line.fail("a variable without a type or a doc text");
        if (!file_.variables.emplace(name, Field{pending_->type, pending_->doc}).second)
            line.fail("the variable is there twice");
        pending_.reset();
    }

    const std::string& text_;
    File file_;
    std::map<std::string, std::string> locals_;  // class of a local table
    std::optional<Pending> pending_;
};

}  // namespace

File read(const std::string& text) {
    return Reader(text).read();
}

}  // namespace luacats
