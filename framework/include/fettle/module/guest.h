#pragma once
// A module written in C++ as one that plugs in: derive from Module as for one that is linked in,
// and say FETTLE_GUEST(Wind, "1.0") in one source file of a shared object that links Fettle::guest.
//
// The library holds a `property::Tree` of its own kind that hands everything on through the C
// interface, so that the shared object fits any program with the same interface, however that was
// compiled. It knows the classes that the module defines; of others it knows names and bases, and
// their values and methods by name. Watching, formulas, history and drawing order stay with the
// program.

#include <memory>

#include <fettle/module/abi.h>
#include <fettle/module/module.h>

namespace fettle::module {

/// What `fettle_module_open` does for a module in C++.
fettle_status open_guest(const fettle_host* host, fettle_module* module, const char* version,
                         std::unique_ptr<Module> (*make)());

}  // namespace fettle::module

#define FETTLE_GUEST(Type, version)                                                                \
    extern "C" FETTLE_MODULE_EXPORT fettle_status fettle_module_open(const fettle_host* host,      \
                                                                     fettle_module* module) {      \
        return fettle::module::open_guest(                                                         \
            host, module, version,                                                                 \
            []() -> std::unique_ptr<fettle::module::Module> { return std::make_unique<Type>(); }); \
    }
