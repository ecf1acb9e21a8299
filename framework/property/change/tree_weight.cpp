#include "tree_weight.h"

#include <utility>

#include <fettle/property/exception_text.h>
#include <fettle/property/question.h>

#include <values/weight.h>

namespace fettle::property {

void TreeWeight::add_name(Symbol name) {
    if (names.insert(name.id()).second) add(weight_of_name);
}

void TreeWeight::add_content(std::uint32_t instance, std::int64_t more) {
    if (more == 0) return;
    content[instance] += more;
    add(more);
}

void TreeWeight::remove_content(std::uint32_t instance) {
    const auto written = content.find(instance);
    if (written == content.end()) return;
    bytes -= written->second;
    content.erase(written);
}

void TreeWeight::replace_content(const Content& image) {
    for (const auto& [instance, weight] : content) bytes -= weight;
    for (const auto& [instance, weight] : image) bytes += weight;
    content = {image.begin(), image.end()};
}

void TreeWeight::pass_mark() {
    mark = INT64_MAX;
    // The callback may set another one.
    const Pin pin(lifetime, "the function given to mark_weight");
    const auto passed = std::exchange(mark_passed, {});
    if (!passed || lifetime.ending) return;
    const Inquiry inquiry(tree, "the function given to mark_weight",
                          "is called in the middle of a change: it cannot");
    try {
        passed();
    } catch (...) {  // An exception must not leave here: the tree is in the middle of a change.
        errors.report({.path = "mark_weight",
                       .where = {},
                       .message = exception_text(),
                       .exception = std::current_exception()});
    }
}

}  // namespace fettle::property
