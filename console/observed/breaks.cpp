#include <observed/breaks.h>

#include <fettle/property/exception_text.h>
#include <fettle/property/path.h>

#include <observed/trace.h>
#include <text/highlight.h>

namespace fettle::console {

using property::Type;
using property::Value;

std::vector<std::string> paths_in(const property::Tree& tree, std::string_view expression) {
    std::vector<std::string> found;
    for (const Span& span : highlight_command(expression)) {
        if (span.token != Token::path) continue;
        std::string path(expression.substr(span.begin, span.end - span.begin));
        try {
            if (property::resolve(tree, path).property != nullptr) found.push_back(std::move(path));
        } catch (const property::Error&) {
            // A function, or a variable.
        }
    }
    return found;
}

std::string Breaks::add(script::Observed condition) {
    Break added{std::move(condition), {}, false};
    std::string problem;
    try {
        added.condition.settle();
        added.last = added.condition.value();
    } catch (const std::exception& error) {
        added.failed = true;  // it may have a value later
        problem = property::exception_text(error);
    }
    all_.push_back(std::move(added));
    return problem;
}

std::vector<std::string> Breaks::texts() const {
    std::vector<std::string> texts;
    for (const Break& each : all_)
        if (!each.condition.text.starts_with("function")) texts.push_back(each.condition.text);
    return texts;
}

std::vector<std::string> Breaks::look() {
    std::vector<std::string> lines;
    for (Break& each : all_) {
        Value now;
        try {
            each.condition.settle();
            now = each.condition.value();
            each.failed = false;
        } catch (const std::exception& error) {
            if (!each.failed)
                lines.push_back("break_when " + each.condition.text + ": " +
                                property::exception_text(error));
            each.failed = true;
            continue;
        }
        const Value before = std::exchange(each.last, now);
        const bool condition = now.is(Type::boolean) || before.is(Type::boolean);
        if (condition ? is_true(now) && !is_true(before) : now != before)
            describe(each, before, lines);
    }
    return lines;
}

std::string Breaks::text_of(const Value& value) const {
    if (value.is(Type::number))
        return tree_.text(value, property::shortest_precision(value.number()));
    if (value.is(Type::vec2)) return tree_.text(value, property::shortest_precision(value.vec2()));
    return tree_.text(value);
}

/// Describes the break with the values that its condition reads: they show why it became true.
void Breaks::describe(const Break& broken, const Value& before,
                      std::vector<std::string>& lines) const {
    lines.push_back("break at step " + std::to_string(tree_.step()) + ": " + broken.condition.text +
                    ": " + text_of(before) + " → " + text_of(broken.last));
    for (const std::string& path : paths_in(tree_, broken.condition.text)) {
        try {
            const property::Place place = property::resolve(tree_, path);
            const property::Provenance written = tree_.who(place.instance, *place.property);
            std::string line = "  " + path + " = " +
                               tree_.text(property::get(tree_, path), place.property->precision());
            if (!place.property->unit.empty()) line += " " + place.property->unit;
            // The simulation reports no writes: if nothing else wrote in this step or the last, it
            // did.
            const bool moved = place.property->simulated &&
                               (!written.known || written.cause.step + 1 < tree_.step());
            if (moved)
                line += "   simulation, step " + std::to_string(tree_.step());
            else if (written.known)
                line += "   " + written.cause.text();
            lines.push_back(std::move(line));
        } catch (const std::exception&) {
            // It was deleted meanwhile.
        }
    }
}

}  // namespace fettle::console
