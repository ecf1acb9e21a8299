#include "authorship.h"

namespace fettle::property {

std::string_view writer_name(Writer writer) {
    switch (writer) {
        case Writer::module:
            return "module";
        case Writer::simulation:
            return "simulation";
        case Writer::script:
            return "script";
        case Writer::console:
            return "console";
        case Writer::inspector:
            return "inspector";
        case Writer::formula:
            return "formula";
        case Writer::undo:
            return "undo";
        case Writer::load:
            return "load";
        case Writer::remote:
            return "remote";
        case Writer::restore:
            return "restore";
    }
    return "?";
}

std::string Cause::text() const {
    return (where.empty() ? std::string(writer_name(writer)) : where) + ", step " +
           std::to_string(step);
}

std::string Authorship::place() const {
    if (locate == nullptr) return {};
    try {
        return (*locate)();
    } catch (...) {  // the write itself is valid
        return {};
    }
}

}  // namespace fettle::property
