#pragma once
// Operations that are running and must not be disturbed.

#include <string_view>
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

    /// Throws if the instance, or one below it, is being deleted. `what`: "move an instance".
    void require_staying(const Instances& instances, Handle instance, std::string_view what) const;
    /// Throws if the instance, or one below it, is being made.
    void require_made(const Instances& instances, Handle instance, std::string_view what) const;
    /// Throws while anything is being deleted. For operations on the whole tree.
    void require_no_deletion(std::string_view what) const;
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
