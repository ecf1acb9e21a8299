#pragma once
// What goes on just now and must not be disturbed.

#include <string_view>
#include <vector>

#include <fettle/property/value.h>

namespace fettle::property {

class Inquiry;
struct Instances;

struct Underway {
    int deletions = 0;                 // one inside the other
    std::vector<Handle> making;        // instances that their modules make, one inside the other
    const Inquiry* inquiry = nullptr;  // the innermost
    bool restoring = false;

    /// Throws where the instance, or one below it, is being deleted. `what`: "move an instance".
    void require_staying(const Instances& instances, Handle instance, std::string_view what) const;
    /// Throws where the instance, or one below it, is being made.
    void require_made(const Instances& instances, Handle instance, std::string_view what) const;
    /// Throws while anything is being deleted, for what changes the tree as a whole.
    void require_no_deletion(std::string_view what) const;
};

/// While it lives, the module of an instance makes it and must not delete it.
class Making {
  public:
    Making(Underway& underway, Handle self) : making_(underway.making) { making_.push_back(self); }
    ~Making() { making_.pop_back(); }
    Making(const Making&) = delete;

  private:
    std::vector<Handle>& making_;
};

}  // namespace fettle::property
