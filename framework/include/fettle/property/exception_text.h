#pragma once
// Messages for users from exceptions of C++.

#include <exception>
#include <string>

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// The message of the exception; for exceptions of the standard library with no readable message
/// (`std::bad_alloc`, `basic_string::_M_create`, an error of the file system), a description of
/// what happened.
std::string exception_text(const std::exception& error);
/// As above, for the exception that is being handled in `catch (...)`: it may be no
/// `std::exception`, and has no message then.
std::string exception_text();

}  // namespace fettle::property

FETTLE_PROPERTY_END
