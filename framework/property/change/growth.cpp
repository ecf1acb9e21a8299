#include "growth.h"

#include <utility>

#include <fettle/property/exception_text.h>
#include <fettle/property/question.h>

namespace fettle::property {

void Growth::pass_mark() {
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
