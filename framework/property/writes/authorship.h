#pragma once
// The current writer, its place in a program, and the step.

#include <functional>
#include <string>

#include <fettle/property/change.h>

namespace fettle::property {

struct Authorship {
    Writer writer = Writer::module;
    std::function<std::string()>* locate = nullptr;  // called when the place is needed; may be null
    std::uint64_t step = 0;

    std::string place() const;
    Cause cause() const { return {.writer = writer, .where = place(), .step = step}; }
};

}  // namespace fettle::property
