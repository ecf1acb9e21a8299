#pragma once
// A class that a module has described in C, without the module: so a trial can replace it by that
// of a new module, as a reload does.

#include <deque>
#include <string>
#include <vector>

#include <fettle/module/abi.h>

#include "stand_in_values.h"
#include "tree_description.h"

namespace fettle::module {

class ClassInC {
  public:
    /// All arguments must outlive the class that is registered with `get`.
    ClassInC(const ClassDescription& from, StandInRows& rows, std::deque<StandInValues>& values);
    ClassInC(const ClassInC&) = delete;
    ClassInC& operator=(const ClassInC&) = delete;

    /// Valid as long as this object.
    const fettle_class& get() const { return class_; }

  private:
    fettle_property in_c(const property::Property& property, const BindingDescription& binding,
                         StandInValues& values);
    fettle_array in_c(const std::vector<property::Field>& fields);
    const char* const* in_c(const std::vector<std::string>& texts);

    Outgoing outgoing_;
    std::deque<std::vector<fettle_field>> fields_;
    std::deque<std::vector<const char*>> texts_;
    std::vector<fettle_property> properties_;
    std::vector<fettle_method> methods_;
    std::vector<fettle_event> events_;
    fettle_class class_{};
};

}  // namespace fettle::module
