#pragma once
// Which function of a plugged-in module runs now, for reports of a crash or of a run that hangs.

#include <fettle/module/export.h>

FETTLE_MODULE_BEGIN

namespace fettle::module {

/// A function of a module, in texts that end with a zero. Null: there is none.
struct RunningFunction {
    const char* module = nullptr;      ///< name of the module; null: no function of a module runs
    const char* function = nullptr;    ///< "step", "set"
    const char* class_name = nullptr;  ///< the class that it belongs to
    const char* member = nullptr;      ///< the property or the method that it belongs to
};

/// The innermost function of a plugged-in module that runs now in the thread of the tree. It uses
/// no lock and allocates nothing, so it may be called in a signal handler and in any thread; in
/// another thread than that of the tree, the result holds only while this function goes on running.
RunningFunction running_function() noexcept;

}  // namespace fettle::module

FETTLE_MODULE_END
