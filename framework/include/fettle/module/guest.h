#pragma once
// Plug-in modules in C++. Derive from Module as for a module that is linked in, and write
// FETTLE_GUEST(Wind, "1.0") in one source file of a shared object that links Fettle::guest.
//
// The library has its own implementation of `property::Tree`, which forwards all calls through the
// C interface. So the shared object works with any program with the same interface, whatever its
// compiler. This tree has the classes that the module defines. Of other classes it has the name
// and the base; their values and methods are reached by name. Watchers, formulas, history and the
// order of drawing are done by the program.

#include <memory>

#include <fettle/module/abi.h>
#include <fettle/module/module.h>

namespace fettle::module {

/// Implements `fettle_module_open` for a module in C++.
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
