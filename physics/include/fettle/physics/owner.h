#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/function.h>

#include <utility>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// For a host that keeps data for every object of a world, such as an instance of a property tree.
/// `World::set_owner` sets the owner of a world. From then on only the host may create and destroy
/// objects in it: while no `Acting` exists, these calls throw `Locked` and change nothing:
///
/// - `create_...`, `clear`, `restore`, `take` (of both worlds), moving the world and assignment to
/// it;
/// - `Body::add`, `Shape::attach`, `Shape::detach`, and `destroy` of everything;
/// - `Shape::set_geometry` with another type of geometry, and `Field::set` with another type of
///   force or other user data;
/// - `set_user_data`, in which the host keeps the link from an object to its data.
///
/// All other calls are allowed. An owner must outlive its worlds, unless they get another owner
/// before.
class Owner {
  public:
    /// Messages end with `advice`, e.g. "it belongs to a tree: delete the instance instead".
    explicit Owner(const char* advice) : advice_(advice) {}
    Owner(const Owner&) = delete;
    Owner& operator=(const Owner&) = delete;

    /// While an object of this class exists, calls count as calls by the owner.
    class Acting {
      public:
        explicit Acting(Owner& owner) : owner_(owner) { ++owner_.acting_; }  ///< begins
        ~Acting() { --owner_.acting_; }                                      ///< ends
        Acting(const Acting&) = delete;
        Acting& operator=(const Acting&) = delete;

      private:
        Owner& owner_;
    };

    /// `call` is called at the end of a step, an edit or a query of a world in which user functions
    /// may be called. The owner can then destroy the objects that it could not destroy inside these
    /// functions. It must not throw.
    void on_unlocked(Function<void()> call) { unlocked_ = std::move(call); }
    /// Calls the function of `on_unlocked`; the library does that.
    void notify_unlocked() const {
        if (const auto call = unlocked_) call();  // a copy, because it may replace itself
    }

    bool acts() const { return acting_ != 0; }      ///< whether an `Acting` exists
    const char* advice() const { return advice_; }  ///< the end of its messages

  private:
    const char* advice_;
    int acting_ = 0;
    Function<void()> unlocked_;
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
