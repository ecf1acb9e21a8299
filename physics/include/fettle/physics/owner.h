#pragma once

#include <fettle/physics/export.h>

#include <functional>
#include <utility>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// For a host that keeps something of its own for every object of a world, such as an instance of a
/// property tree. `World::set_owner` gives it the world. From then on the host alone makes and ends
/// what is in it: while no `Acting` lives, these throw `Locked` and change nothing:
///
/// - `create_...`, `clear`, `restore`, `take` (of both worlds) and assignment to the world;
/// - `Body::add`, `Shape::attach`, `Shape::detach`, and `destroy` of everything;
/// - `set_user_data`, by which the host knows what is whose.
///
/// All else is free. It must outlive the worlds that it was given, or be taken from them.
class Owner {
  public:
    /// Messages end with `advice`: "it belongs to a tree: delete the instance instead".
    explicit Owner(const char* advice) : advice_(advice) {}
    Owner(const Owner&) = delete;
    Owner& operator=(const Owner&) = delete;

    /// While it lives, what is called comes from the owner.
    class Acting {
      public:
        explicit Acting(Owner& owner) : owner_(owner) { ++owner_.acting_; }
        ~Acting() { --owner_.acting_; }
        Acting(const Acting&) = delete;
        Acting& operator=(const Acting&) = delete;

      private:
        Owner& owner_;
    };

    /// Called when a step, an edit or a query of a world is over in which functions of the user
    /// could be called: what the owner could not end inside of them it may end now. It must not
    /// throw.
    void on_unlocked(std::function<void()> call) { unlocked_ = std::move(call); }
    void tell_unlocked() const {
        if (unlocked_) unlocked_();
    }

    bool acts() const { return acting_ != 0; }
    const char* advice() const { return advice_; }

  private:
    const char* advice_;
    int acting_ = 0;
    std::function<void()> unlocked_;
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
