#pragma once
// Operations that are running, and checks that refuse calls which would disturb them.

#include <cstdint>
#include <string_view>
#include <unordered_set>
#include <vector>

#include <fettle/property/question.h>
#include <fettle/property/value.h>

namespace fettle::property {

struct Instances;

struct Underway {
    /// An instance that must stay where it is while a module is called. `state`: "is being made".
    struct Held {
        Handle instance;
        const char* state;
    };

    int deletions = 0;                 // nested deletions
    std::vector<Held> held;            // nested
    const Inquiry* inquiry = nullptr;  // the innermost inquiry
    bool restoring = false;
    bool ending_rows = false;  // a restore ends the rows of instances that it deletes
    /// Slots of the instances whose rows a restore will make.
    std::unordered_set<std::uint32_t> unmade{};

    /// Throws if the instance, or one below it, is being deleted. `what`: "move an instance".
    void require_staying(const Instances& instances, Handle instance, std::string_view what) const;
    /// Throws if the instance, or one below it, is held: its module is making or placing it.
    void require_settled(const Instances& instances, Handle instance, std::string_view what) const;
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

inline constexpr const char being_made[] = "is being made";
inline constexpr const char being_moved[] = "is being moved";
inline constexpr const char being_left[] = "is left by an instance that is being moved";

/// While it lives, the instance, and those above it, can be neither deleted nor moved: a module is
/// making or placing it. A null handle holds nothing.
class Hold {
  public:
    Hold(Underway& underway, Handle instance, const char* state) : held_(underway.held) {
        held_.push_back({instance, state});
    }
    ~Hold() { held_.pop_back(); }
    Hold(const Hold&) = delete;

  private:
    std::vector<Underway::Held>& held_;
};

}  // namespace fettle::property
