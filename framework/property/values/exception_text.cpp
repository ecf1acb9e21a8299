// Readable messages of exceptions.

#include <fettle/property/exception_text.h>

#include <filesystem>
#include <new>
#include <stdexcept>

namespace fettle::property {

std::string exception_text(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
        return "not enough memory: the system has none to give";
    if (dynamic_cast<const std::length_error*>(&error) != nullptr)
        return "not enough memory: no text or list can be that long";
    if (const auto* file = dynamic_cast<const std::filesystem::filesystem_error*>(&error))
        return file->path1().string() + ": " + file->code().message();
    return error.what();
}

std::string exception_text() {
    try {
        throw;
    } catch (const std::exception& error) {
        return exception_text(error);
    } catch (...) {
        return "an exception of no known type";
    }
}

}  // namespace fettle::property
