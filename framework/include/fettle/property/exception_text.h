#pragma once
// What a person reads of an exception that C++ itself has thrown.

#include <exception>
#include <string>

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// The message of the exception; for what the standard library throws without a message for people
/// (`std::bad_alloc`, `basic_string::_M_create`, a failure of the file system), what has happened.
std::string exception_text(const std::exception& error);
/// The same of the exception that is being handled, for `catch (...)`: C++ may throw what is no
/// `std::exception`, and has no message then.
std::string exception_text();

}  // namespace fettle::property

FETTLE_PROPERTY_END
