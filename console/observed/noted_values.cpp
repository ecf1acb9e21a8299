#include <observed/noted_values.h>

#include <algorithm>

#include <text/short_numbers.h>

namespace fettle::console {

NotedValues::NotedValues(const property::Tree& tree) {
    std::size_t noted = 0;
    tree.each_below(tree.root(), [&](property::Handle instance) {
        if (instance == tree.root() || !complete_) return;
        std::vector<Noted>& values = instances_[tree.path(instance)];
        for (const property::Property* const each : tree.properties(instance)) {
            // A derived value, such as a mass, changes by an edit only.
            const bool moves = each->simulated && each->derives_from.empty();
            if (moves || each->transient || each->read_only || each->hidden) continue;
            if (noted++ == most) {
                complete_ = false;
                return;
            }
            values.push_back({each->name, tree.peek(instance, *each), each->unit});
        }
    });
}

namespace {

using Values = std::vector<NotedValues::Noted>;

/// `digits`: of a number; 0: all of them.
std::string text_of(const property::Tree& tree, const NotedValues::Noted* noted, int digits) {
    if (noted == nullptr) return "none";
    std::string text = tree.text(noted->value, property::Precision::single_precision);
    if (digits > 0 && noted->value.is(property::Type::number)) {
        text = short_number(noted->value.number(), digits);
    }
    if (!noted->unit.empty()) text += " " + noted->unit;
    return text;
}

const NotedValues::Noted* find_noted(const Values& values, const std::string& name) {
    const auto found = std::ranges::find(values, name, &NotedValues::Noted::name);
    return found == values.end() ? nullptr : &*found;
}

/// Differences in one property: lines for the first instances, and the number of instances.
struct Difference {
    std::vector<std::string> lines;
    std::size_t instances = 0;
};
constexpr std::size_t most_of_one = 3;  // lines

void add_differences(const property::Tree& tree, const std::string& path, const Values& a,
                     const Values& b, std::vector<std::string>& names,
                     std::map<std::string, Difference>& found) {
    const auto add = [&](const std::string& name, const NotedValues::Noted* of_a,
                         const NotedValues::Noted* of_b) {
        std::string of_one = text_of(tree, of_a, 4), of_other = text_of(tree, of_b, 4);
        if (of_one == of_other) {
            of_one = text_of(tree, of_a, 0);
            of_other = text_of(tree, of_b, 0);
        }
        if (of_one == of_other)
            return;  // differences too small to show, or different deleted instances
        Difference& difference = found[name];
        if (difference.instances == 0) names.push_back(name);
        if (difference.instances++ < most_of_one)
            difference.lines.push_back(path + "." + name + ": A " + of_one + ", B " + of_other);
    };
    for (const NotedValues::Noted& of_a : a) {
        const NotedValues::Noted* const of_b = find_noted(b, of_a.name);
        if (of_b == nullptr || !(of_b->value == of_a.value)) add(of_a.name, &of_a, of_b);
    }
    for (const NotedValues::Noted& of_b : b)
        if (find_noted(a, of_b.name) == nullptr) add(of_b.name, nullptr, &of_b);
}

}  // namespace

std::vector<std::string> differences(const property::Tree& tree, const NotedValues& a,
                                     const NotedValues& b) {
    std::vector<std::string> names, lines;  // of properties, in the order of the lines
    std::map<std::string, Difference> found;
    for (const auto& [path, values] : a.instances())
        if (const auto other = b.instances().find(path); other != b.instances().end())
            add_differences(tree, path, values, other->second, names, found);
    for (const std::string& name : names) {
        Difference& its = found[name];
        if (const std::size_t others = its.instances - its.lines.size(); others > 0)
            its.lines.back() +=
                "; and in " + std::to_string(others) + (others == 1 ? " other" : " others");
        lines.insert(lines.end(), its.lines.begin(), its.lines.end());
    }
    const auto add_lone = [&](const NotedValues& one, const NotedValues& other, const char* where) {
        for (const auto& [path, values] : one.instances())
            if (!other.instances().contains(path)) lines.push_back(path + where);
    };
    add_lone(a, b, ": in A only");
    add_lone(b, a, ": in B only");
    return lines;
}

}  // namespace fettle::console
