#pragma once

#include <fettle/physics/geometry.h>
#include <forms/form_data.h>

#include <atomic>

namespace fettle::physics::detail {

/// The data of forms that are copies of each other.
struct SharedForm : FormData {
    explicit SharedForm(FormData data) : FormData(std::move(data)) {}
    mutable std::atomic<uint32_t> forms = 1;
};

/// The data of a form of the public interface.
struct FormAccess {
    static const FormData& data(const Form& form) { return *form.data_; }
};

}  // namespace fettle::physics::detail
