// Conditions: a parser by recursive descent, and a program in postfix form that is run for each
// instance.

#include <fettle/property/condition.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include <fettle/property/class.h>
#include <fettle/property/error.h>
#include <fettle/property/spelling.h>
#include <fettle/property/tree.h>

#include "condition_words.h"

namespace fettle::property {

/// The parts of a compiled condition.
namespace condition_program {

enum class Do : std::uint8_t {
    constant,
    read,
    less,
    less_or_equal,
    equal,
    unequal,
    add,
    subtract,
    multiply,
    divide,
    negate,
    invert,
    skip_if_false,  // `and`: keeps the value and skips the other operand, or drops the value
    skip_if_true    // `or`
};

struct Step {
    Do action = Do::constant;
    std::size_t index = 0;  // of a constant or of a place; the number of steps to skip
};

/// A value to be read: `position.x` is the name `position` and one part.
struct Lookup {
    std::string name;
    struct Part {
        std::string name;
        std::size_t index = 0;  // from 1; 0: the name counts
    };
    std::vector<Part> parts;
    bool known = false;  // an instance had it

    std::string text() const {
        std::string all = name;
        for (const Part& part : parts)
            all += part.index > 0 ? "[" + std::to_string(part.index) + "]" : "." + part.name;
        return all;
    }
};

}  // namespace condition_program

namespace {

using namespace condition_program;

constexpr std::size_t longest_condition = 2000;  // bytes
constexpr int deepest = 50;

bool truth(const Tree& tree, const Value& value) {
    if (value.is(Type::boolean)) return value.boolean();
    if (value.is(Type::reference)) return tree.alive(value.reference());
    return !value.is_nil();
}

bool equal(const Value& a, const Value& b) {
    if (a.is_numeric() && b.is_numeric()) return a.as_double() == b.as_double();
    return a == b;
}

/// False for values that have no order.
bool less(const Value& a, const Value& b, bool or_equal) {
    if (a.is_numeric() && b.is_numeric())
        return or_equal ? a.as_double() <= b.as_double() : a.as_double() < b.as_double();
    if (a.is(Type::text) && b.is(Type::text))
        return or_equal ? a.text() <= b.text() : a.text() < b.text();
    return false;
}

/// nil if one of them is not a number.
Value computed(Do action, const Value& a, const Value& b) {
    if (!a.is_numeric() || !b.is_numeric()) return {};
    const double x = a.as_double(), y = b.as_double();
    switch (action) {
        case Do::add:
            return x + y;
        case Do::subtract:
            return x - y;
        case Do::multiply:
            return x * y;
        default:
            return x / y;
    }
}

/// A property or a child; none if the instance has neither.
std::optional<Value> member(const Tree& tree, Handle instance, const std::string& name) {
    if (!tree.alive(instance)) return Value();
    if (const Property* property = tree.find(instance, name)) return tree.get(instance, *property);
    if (const Handle child = tree.child(instance, name)) return Value(child);
    return std::nullopt;
}

std::optional<Value> part(const Tree& tree, const Value& whole, const Lookup::Part& wanted) {
    if (whole.is_nil()) return Value();
    if (wanted.index > 0) {
        if (!whole.is(Type::list)) return std::nullopt;
        return wanted.index <= whole.list().size() ? whole.list()[wanted.index - 1] : Value();
    }
    if (whole.is(Type::reference)) return member(tree, whole.reference(), wanted.name);
    if (whole.is(Type::vec2)) {
        if (wanted.name == "x") return Value(whole.vec2().x);
        if (wanted.name == "y") return Value(whole.vec2().y);
        if (wanted.name == "length") return Value(whole.vec2().length());
    }
    if (whole.is(Type::color)) {
        const Color color = whole.color();
        if (wanted.name == "r") return Value(color.r);
        if (wanted.name == "g") return Value(color.g);
        if (wanted.name == "b") return Value(color.b);
        if (wanted.name == "a") return Value(color.a);
    }
    return std::nullopt;
}

}  // namespace

struct Condition::Program {
    std::vector<Step> steps;
    std::vector<Value> constants;
    std::vector<Lookup> reads;
    std::vector<Value> stack;
    const Lookup* last_vector = nullptr;  // what was read last and is a vector
    const Lookup* unordered = nullptr;    // the same, if it was compared with a number by its size

    Value look(const Tree& tree, Handle instance, Lookup& read) {
        std::optional<Value> value = member(tree, instance, read.name);
        if (!value)
            if (const Class* of = tree.find_class(read.name))
                value = Value(tree.class_of(instance).is_a(*of));
        for (const Lookup::Part& each : read.parts) {
            if (!value) return {};
            value = part(tree, *value, each);
        }
        if (!value) return {};
        read.known = true;
        if (value->is(Type::vec2)) last_vector = &read;
        return *value;
    }

    Value run(const Tree& tree, Handle instance);
};

Value Condition::Program::run(const Tree& tree, Handle instance) {
    stack.clear();
    const auto pop = [this] {
        Value top = std::move(stack.back());
        stack.pop_back();
        return top;
    };
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const Step& step = steps[i];
        switch (step.action) {
            case Do::constant:
                stack.push_back(constants[step.index]);
                continue;
            case Do::read:
                stack.push_back(look(tree, instance, reads[step.index]));
                continue;
            case Do::skip_if_false:
            case Do::skip_if_true:
                if (truth(tree, stack.back()) == (step.action == Do::skip_if_true))
                    i += step.index;
                else
                    stack.pop_back();
                continue;
            case Do::invert:
                stack.emplace_back(!truth(tree, pop()));
                continue;
            case Do::negate:
                stack.push_back(computed(Do::subtract, Value(0.0), pop()));
                continue;
            default:
                break;
        }
        const Value b = pop(), a = pop();
        if (step.action == Do::equal || step.action == Do::unequal)
            stack.emplace_back(equal(a, b) == (step.action == Do::equal));
        else if (step.action == Do::less || step.action == Do::less_or_equal) {
            stack.emplace_back(less(a, b, step.action == Do::less_or_equal));
            if ((a.is(Type::vec2) && b.is_numeric()) || (a.is_numeric() && b.is(Type::vec2)))
                unordered = last_vector;
        } else
            stack.push_back(computed(step.action, a, b));
    }
    return pop();
}

// --- The parser

namespace {

template <class Program>
class Parser {
  public:
    Parser(std::string_view text, Program& program) : words_(text), program_(program) {
        either();
        if (words_.kind != Token::end)
            words_.fail("expected an operator or the end, got " + words_.found());
    }

  private:
    void add(Do action, std::size_t index = 0) { program_.steps.push_back({action, index}); }

    /// A chain of operands with `and`, or with `or`: an operand that decides skips the next one.
    template <class Operand>
    void chain(std::string_view word, Do skip, const Operand& operand) {
        operand();
        while (words_.is(word)) {
            words_.next();
            const std::size_t at = program_.steps.size();
            add(skip);
            operand();
            program_.steps[at].index = program_.steps.size() - at - 1;
        }
    }
    void either() {
        if (++depth_ > deepest)
            words_.fail("brackets are nested more than " + std::to_string(deepest) + " deep");
        chain("or", Do::skip_if_true,
              [this] { chain("and", Do::skip_if_false, [this] { comparison(); }); });
        --depth_;
    }
    void comparison() {
        const std::size_t begin = program_.steps.size();
        sum();
        for (;;) {
            const std::string_view sign = words_.word;
            if (words_.kind != Token::sign || sign.find_first_of("<>=~") != 0) return;
            words_.next();
            if (sign[0] == '>') {
                // a > b is b < a: the order in which the operands are computed does not matter.
                const std::size_t middle = program_.steps.size();
                sum();
                std::rotate(program_.steps.begin() + static_cast<std::ptrdiff_t>(begin),
                            program_.steps.begin() + static_cast<std::ptrdiff_t>(middle),
                            program_.steps.end());
            } else {
                sum();
            }
            add(sign == "=="       ? Do::equal
                : sign == "~="     ? Do::unequal
                : sign.size() == 2 ? Do::less_or_equal
                                   : Do::less);
            if (words_.kind == Token::sign && words_.word.find_first_of("<>=~") == 0)
                words_.fail("comparisons are joined by \"and\"");
        }
    }
    void sum() {
        product();
        while (words_.is("+") || words_.is("-")) {
            const Do action = words_.is("+") ? Do::add : Do::subtract;
            words_.next();
            product();
            add(action);
        }
    }
    void product() {
        unary();
        while (words_.is("*") || words_.is("/")) {
            const Do action = words_.is("*") ? Do::multiply : Do::divide;
            words_.next();
            unary();
            add(action);
        }
    }
    void unary() {
        if (words_.is("not") || words_.is("-")) {
            const Do action = words_.is("not") ? Do::invert : Do::negate;
            words_.next();
            if (++depth_ > deepest) words_.fail("too many of \"not\" and \"-\"");
            unary();
            --depth_;
            return add(action);
        }
        value();
    }
    void value() {
        if (words_.is("(")) {
            words_.next();
            either();
            if (!words_.is(")")) words_.fail("expected ), got " + words_.found());
            return words_.next();
        }
        if (words_.kind == Token::name && !reserved()) return read();
        Value constant;
        if (words_.kind == Token::number) {
            double number = 0;
            std::from_chars(words_.word.data(), words_.word.data() + words_.word.size(), number);
            constant = Value(number);
        } else if (words_.kind == Token::text) {
            constant = Value(words_.value);
        } else if (words_.is("true") || words_.is("false")) {
            constant = Value(words_.is("true"));
        } else if (!words_.is("nil")) {
            words_.fail("expected a property or a value, got " + words_.found());
        }
        words_.next();
        add(Do::constant, program_.constants.size());
        program_.constants.push_back(std::move(constant));
    }
    bool reserved() const {
        for (const std::string_view word : {"and", "or", "not", "true", "false", "nil"})
            if (words_.word == word) return true;
        return false;
    }
    void read() {
        Lookup made{.name = std::string(words_.word), .parts = {}};
        words_.next();
        while (words_.is(".") || words_.is("[")) {
            const bool index = words_.is("[");
            words_.next();
            if (index) {
                std::size_t number = 0;
                const char* const end = words_.word.data() + words_.word.size();
                const auto parsed = std::from_chars(words_.word.data(), end, number);
                if (words_.kind != Token::number || parsed.ptr != end || number == 0)
                    words_.fail("expected an index from 1, got " + words_.found());
                made.parts.push_back({{}, number});
                words_.next();
                if (!words_.is("]")) words_.fail("expected ], got " + words_.found());
            } else {
                if (words_.kind != Token::name)
                    words_.fail("expected a name after the dot, got " + words_.found());
                made.parts.push_back({std::string(words_.word)});
            }
            words_.next();
        }
        if (words_.is("(")) words_.fail("a condition calls no functions");
        add(Do::read, program_.reads.size());
        program_.reads.push_back(std::move(made));
    }

    Words words_;
    Program& program_;
    int depth_ = 0;
};

}  // namespace

Condition::Condition(std::string_view text) : program_(std::make_unique<Program>()) {
    if (text.size() > longest_condition)
        throw Error(ErrorKind::rejected,
                    "a condition has at most " + std::to_string(longest_condition) + " bytes");
    const Parser parser(text, *program_);
}
Condition::~Condition() = default;
Condition::Condition(Condition&&) noexcept = default;
Condition& Condition::operator=(Condition&&) noexcept = default;

bool Condition::is_meant(std::string_view text) {
    if (text.find_first_of("<>=~()+/") != std::string_view::npos || text.starts_with('!') ||
        text.find("&&") != std::string_view::npos || text.find("||") != std::string_view::npos)
        return true;  // with the signs of other languages, too: the message has those of Lua
    std::size_t at = 0;
    while (at < text.size()) {
        while (at < text.size() && is_space(text[at])) ++at;
        std::size_t end = at;
        while (end < text.size() && !is_space(text[end])) ++end;
        const std::string_view word = text.substr(at, end - at);
        if (word == "and" || word == "or" || word == "not") return true;
        at = end;
    }
    return false;
}

bool Condition::holds(const Tree& tree, Handle instance) {
    if (!tree.alive(instance)) return false;
    try {
        return truth(tree, program_->run(tree, instance));
    } catch (const Error&) {
        return false;  // a formula that fails
    }
}

std::size_t Condition::weight() const {
    return program_->steps.size();
}

std::string Condition::problem(const Tree& tree) const {
    const auto first_unknown = std::ranges::find(program_->reads, false, &Lookup::known);
    if (first_unknown == program_->reads.end()) {
        if (program_->unordered == nullptr) return {};
        const std::string vector = program_->unordered->text();
        return vector + " is a vector (write " + vector + ".length, " + vector + ".x or " + vector +
               ".y)";
    }
    std::vector<std::string> names;
    for (const Class* of : tree.classes()) {
        names.push_back(of->name());
        for (const Property* property : of->properties())
            if (property->owner == of && !property->hidden) names.push_back(property->name);
    }
    const bool whole = first_unknown->parts.empty() ||
                       std::ranges::find(names, first_unknown->name) == names.end();
    return "nothing has \"" + first_unknown->text() + "\"" +
           (whole ? suggestion(first_unknown->name, names) : std::string());
}

}  // namespace fettle::property
