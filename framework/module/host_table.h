#pragma once
// The host's side of the border: the functions a module may call, each of which turns what the tree
// throws into a status and keeps its message for `last_error`.

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include <fettle/module/abi.h>
#include <fettle/property/snapshot.h>
#include <fettle/property/tree.h>

#include "border_value.h"

namespace fettle::module {

/// The table one module is given. Stays where it is: the module keeps its address.
class HostTable {
  public:
    HostTable();
    HostTable(const HostTable&) = delete;
    HostTable& operator=(const HostTable&) = delete;

    const fettle_host& table() const { return table_; }
    /// The tree that calls act on; null while the module is not attached to one.
    property::Tree* tree = nullptr;
    /// The module as the tree knows it; null while it is none of its parts.
    property::SnapshotPart* part = nullptr;
    /// What `define_class` does while the module attaches; null: it refuses.
    std::function<void(const fettle_class&)> define_class{};
    /// Asked first by `create`: an instance that is there already and is to be taken over.
    std::function<property::Handle(const property::Class&, property::Handle parent,
                                   const char* name)>
        adopt{};
    std::function<void(std::string_view)> print{};

    /// Why the module's last callback refused, as it told; "" when it did not say. Forgets it.
    std::string take_reason();
    /// Of the callback that has just returned `status`. Throws std::invalid_argument with the
    /// module's reason unless it is FETTLE_OK; where it gives none, with that of the host function
    /// that refused with the same status, which the callback has handed on.
    void require(fettle_status status, std::string_view what);

    // --- For the functions of the table
    /// Runs `body` and turns what it throws into a status.
    template <class Body>
    fettle_status guarded(Body&& body) noexcept;
    Outgoing& outgoing() {
        outgoing_.clear();
        return outgoing_;
    }
    std::string kept_text;  // a text given to the module until its next call

  private:
    friend struct HostFunctions;
    fettle_host table_{};
    std::string error_, reason_;
    fettle_status error_status_ = FETTLE_OK;  // of `error_`, until the callback has returned
    Outgoing outgoing_;
};

template <class Body>
fettle_status HostTable::guarded(Body&& body) noexcept {
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

/// `painter` as a module sees it. Valid as long as `painter`.
fettle_painter painter_table(property::Painter& painter);

}  // namespace fettle::module
