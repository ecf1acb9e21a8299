#pragma once
// The host functions that a module may call. Each of them turns an exception of the tree into a
// status and keeps its message for `last_error`.

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include <fettle/module/abi.h>
#include <fettle/property/snapshot.h>
#include <fettle/property/tree.h>

#include "c_values.h"
#include "running.h"

namespace fettle::module {

/// The table for one module. It must not move: the module keeps its address.
class HostTable {
  public:
    HostTable();
    HostTable(const HostTable&) = delete;
    HostTable& operator=(const HostTable&) = delete;

    const fettle_host& table() const { return table_; }
    /// The tree that calls act on; null while no tree is attached.
    property::Tree* tree = nullptr;
    /// The module as a part of the tree's snapshots; null if it is none.
    property::SnapshotPart* part = nullptr;
    /// Called by `define_class` while the module attaches; without it, `define_class` refuses.
    std::function<void(const fettle_class&)> define_class{};
    /// Called first by `create` during a reload: returns an existing instance to reuse, or a null
    /// handle.
    std::function<property::Handle(const property::Class&, property::Handle parent,
                                   const char* name)>
        adopt{};
    /// Whether the module has no such class yet: during a reload, one of its own that it has not
    /// registered again. It and its instances are not found then, as at the start of a game.
    std::function<bool(const property::Class&)> unknown{};
    std::function<void(std::string_view)> print{};
    /// Gets the errors of functions that return no status: "step: no wind". Without it, they are
    /// printed.
    std::function<void(const std::string&)> failed{};
    /// The module, for `running_function`.
    Named named{};

    /// Returns and clears the reason that the module's last callback gave; "" if it gave none.
    std::string take_reason();
    /// Throws std::invalid_argument unless `status` of the last callback is FETTLE_OK. The message
    /// is the module's reason. Without one, it is the error of the host function that returned the
    /// same status, which the callback has passed on.
    void require(fettle_status status, std::string_view what);

    /// Calls a function of the module that returns no status. If it gives a reason to `fail`, this
    /// is an error of the module.
    template <class Function>
    auto run(const Named& of, const char* function, Function&& body) {
        struct Reported {
            HostTable& host;
            const Named& of;
            const char* function;
            const Running running{of, function};
            ~Reported() { host.report_failure(of, function); }
        };
        const Reported reported{*this, of, function};
        return body();
    }

    /// Gives this reason to `fail` if the module gave none.
    void fail_unless_failed(const char* why) {
        if (reason_.empty()) reason_ = why;
    }

    /// Whether the module has called a function of the table that has not returned: then code of
    /// the module is running.
    bool called() const { return calls_ != 0; }

    // --- For the functions of the table
    /// As long as a `Call` lives, the module is calling a function of the table.
    class Call {
      public:
        explicit Call(HostTable& host) : host_(host) { ++host_.calls_; }
        ~Call() { --host_.calls_; }
        Call(const Call&) = delete;
        Call& operator=(const Call&) = delete;

      private:
        HostTable& host_;
    };
    /// Runs `body` and turns an exception into a status.
    template <class Body>
    fettle_status guarded(Body&& body) noexcept;
    Outgoing& outgoing() {
        outgoing_.clear();
        return outgoing_;
    }
    std::string kept_text;  // a text that the module may use until its next call

  private:
    friend struct HostFunctions;
    void report_failure(const Named& of, const char* function) noexcept;

    fettle_host table_{};
    std::string error_, reason_;
    fettle_status error_status_ = FETTLE_OK;  // of `error_`; reset when the callback has returned
    int calls_ = 0;                           // nested
    Outgoing outgoing_;
};

template <class Body>
fettle_status HostTable::guarded(Body&& body) noexcept {
    const Call call(*this);
    try {
        if (tree == nullptr)
            throw std::logic_error("there is no tree before `attach` and after `close`");
        body(*tree);
        return FETTLE_OK;
    } catch (const property::Error& error) {
        error_ = error.what();
        return error_status_ = status_of(error.kind());
    } catch (const std::exception& error) {
        error_ = error.what();
    } catch (...) {
        error_ = "an exception of no known type";
    }
    return error_status_ = FETTLE_ERR_FAILED;
}

/// The C table of `painter`. Valid as long as `painter`.
fettle_painter painter_table(property::Painter& painter);

}  // namespace fettle::module
