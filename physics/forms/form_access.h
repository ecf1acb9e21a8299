#pragma once

#include <fettle/physics/geometry.h>
#include <forms/form_data.h>

namespace fettle::physics::detail {

/// The data of a form of the public interface.
struct FormAccess {
    static const FormData& data(const Form& form) { return *form.data_; }
};

}  // namespace fettle::physics::detail
