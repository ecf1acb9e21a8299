#include "errors.h"

#include <fettle/property/exception_text.h>

namespace fettle::property {

void HandlerErrors::report(std::exception_ptr& kept, const std::function<std::string()>& path,
                           const std::string& where) const {
    try {
        if (!sink || lifetime.ending) throw;
        report({.path = path(),
                .where = where,
                .message = exception_text(),
                .exception = std::current_exception()});
    } catch (...) {
        if (!kept) kept = std::current_exception();
    }
}

void HandlerErrors::report(const HandlerError& error) const {
    // The sink may replace itself while it runs.
    if (const auto now = sink) now(error);
}

}  // namespace fettle::property
