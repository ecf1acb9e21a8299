#include <observed/breaks.h>

#include <algorithm>
#include <utility>

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

Value Breaks::Break::compute() {
    condition.compute_formulas();
    return condition.value();
}

std::string Breaks::add(script::Observed condition) {
    remove(condition.text);
    Break added{std::move(condition), {}, false};
    std::string message = "breaks when " + added.condition.text;
    try {
        added.last = added.compute();
        message += added.last.is(Type::boolean) ? " becomes true; it is " : " changes; it is ";
        message += text_of(added.last);
        if (!added.condition.unit.empty()) message += " " + added.condition.unit;
    } catch (const std::exception& error) {
        added.failed = true;  // it may have a value later
        message += " becomes true or changes; it has no value yet: " +
                   without_advice(property::exception_text(error));
    }
    all_.push_back(std::move(added));
    return message;
}

std::size_t Breaks::remove(const std::string& text) {
    return std::erase_if(
        all_, [&](const Break& each) { return text.empty() || each.condition.text == text; });
}

std::vector<std::string> Breaks::texts() const {
    std::vector<std::string> texts;
    texts.reserve(all_.size());
    for (const Break& each : all_) texts.push_back(each.condition.text);
    return texts;
}

std::vector<std::string> Breaks::texts_to_keep() const {
    std::vector<std::string> texts;
    for (const Break& each : all_)
        if (!each.condition.is_function()) texts.push_back(each.condition.text);
    return texts;
}

std::string Breaks::set_on(const std::string& path) const {
    const auto found = std::ranges::find(
        all_, path, [](const Break& each) -> const std::string& { return each.condition.text; });
    return path.empty() || found == all_.end() ? std::string() : found->condition.text;
}

std::vector<std::string> Breaks::check() {
    std::vector<std::string> lines;
    for (Break& each : all_) {
        Value now;
        try {
            now = each.compute();
            each.failed = false;
        } catch (const std::exception& error) {
            if (!each.failed)
                lines.push_back("break at step " + std::to_string(tree_.step()) + ": " +
                                each.condition.text + " has no value any more, so the game is " +
                                "paused: " + without_advice(property::exception_text(error)));
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

void Breaks::begin_again() {
    for (Break& each : all_) {
        try {
            each.last = each.compute();
        } catch (const std::exception&) {
            // `check` reports it.
        }
    }
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
            const property::Provenance written = tree_.last_writer(place.instance, *place.property);
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
