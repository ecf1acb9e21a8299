#pragma once
// Operations that are running and must not be disturbed.

#include <cstdint>
#include <string_view>
#include <unordered_set>
#include <vector>

#include <fettle/property/value.h>

namespace fettle::property {

class Inquiry;
struct Instances;

struct Underway {
    int deletions = 0;                 // nested deletions
    std::vector<Handle> making;        // instances that their modules are making; nested
    const Inquiry* inquiry = nullptr;  // the innermost inquiry
    bool restoring = false;
    bool ending_rows = false;  // a restore ends the rows of instances that it deletes
    /// Slots of the instances whose rows a restore will make.
    std::unordered_set<std::uint32_t> unmade{};

    /// Throws if the instance, or one below it, is being deleted. `what`: "move an instance".
    void require_staying(const Instances& instances, Handle instance, std::string_view what) const;
    /// Throws if the instance, or one below it, is being made.
    void require_made(const Instances& instances, Handle instance, std::string_view what) const;
    /// Throws while anything is being deleted. For operations on the whole tree.
    void require_no_deletion(std::string_view what) const;
    /// Throws while a restore calls modules to end and to make rows, because it replaces the
    /// instances that existed at its beginning.
    void require_all_rows(std::string_view what) const;
    /// The same for a change of one instance and of those below it. Throws if one of these has no
    /// row yet.
    void require_rows(const Instances& instances, Handle instance, std::string_view what) const;
    /// The same for a change below `parent`, which may be null.
    void require_row_above(const Instances& instances, Handle parent, std::string_view what) const;

  private:
    void require_no_rows_ending(std::string_view what) const;
};

/// While it lives, a module makes the instance and must not delete it.
class Making {
  public:
    Making(Underway& underway, Handle self) : making_(underway.making) { making_.push_back(self); }
    ~Making() { making_.pop_back(); }
    Making(const Making&) = delete;

  private:
    std::vector<Handle>& making_;
};

}  // namespace fettle::property
