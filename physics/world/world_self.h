#pragma once

#include <fettle/physics/callbacks.h>
#include <fettle/physics/host_access.h>
#include <fettle/physics/owner.h>
#include <state/velocity_sums.h>
#include <threads/pool.h>
#include <world/world_link.h>
#include <world/world_observer.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <vector>

namespace fettle::physics::detail {

// Names of the user functions in messages.
inline constexpr const char in_filter[] = "the filter (World::set_filter)";
inline constexpr const char in_mixing[] = "the mixing callback (World::set_mixing)";
inline constexpr const char in_before_solve[] =
    "the before-solve callback (World::set_before_solve)";
inline constexpr const char in_accept[] = "QueryFilter::accept";
inline constexpr const char in_visitor[] = "the visitor of a query";
inline constexpr const char in_refresh[] = "the refresh callback (HostAccess::on_refresh)";
inline constexpr const char in_draw[] = "a function of the DebugDraw (World::draw)";
inline constexpr const char in_velocity[] =
    "the velocity function of a body (Body::set_velocity_function)";
inline constexpr const char in_position[] =
    "the position function of a body (Body::set_position_function)";
inline constexpr const char in_recording[] =
    "the function that takes a recording (World::start_recording)";
inline constexpr const char in_step[] = "a step";
inline constexpr const char in_edit[] = "an edit";

/// Data of a world that are not part of its state: identity, user functions, owner, threads, lock,
/// and accounts. Copying or restoring a state does not change them.
struct WorldSelf {
    WorldLink* link = nullptr;  ///< null: a state without a world
    PairFilter filter;
    ContactCallback mix, before_solve;
    bool parallel_callbacks = false;   ///< these two are called on all threads of a step
    bool serial_callbacks = false;     ///< not even then: HostAccess::set_serial_callbacks
    bool calling_in_parallel = false;  ///< they are being called so
    RefreshCallback refresh;
    std::vector<Function<void()>> after_step;  ///< to be called once, after a step
    const Owner* owner = nullptr;              ///< only it may populate the world; null: all may
    std::unique_ptr<ThreadPool> pool;
    std::vector<VelocitySums> sums;        ///< of the bodies of `World::keep_account`
    std::vector<BodyFunctions> functions;  ///< of bodies, by slot: at most one for a slot

    WorldSelf();
    ~WorldSelf();
    WorldSelf(const WorldSelf&) = delete;
    WorldSelf& operator=(const WorldSelf&) = delete;

    bool has_contact_callbacks() const { return mix || before_solve; }

    /// While user functions may be called, editing is forbidden.
    bool locked() const { return (work_.load(std::memory_order_relaxed) & ~marks) != 0; }
    /// In the middle of a step or an edit, copying the state is forbidden as well.
    bool in_the_middle() const {
        return (work_.load(std::memory_order_relaxed) & ~marks) >= middle;
    }
    /// Memory ran out in the middle of a change, so the state may be inconsistent: all functions
    /// that would use it throw `Damaged`, until another state replaces it.
    bool damaged() const { return (work_.load(std::memory_order_relaxed) & damage) != 0; }
    void set_damaged();
    void clear_damage() { work_.fetch_and(~damage, std::memory_order_relaxed); }
    /// True if a function that the World was calling destroyed it.
    bool orphaned() const { return bool(orphan_); }

    /// Throws Locked if editing is forbidden. `of` and `function`: the called type and method.
    void may_edit(const char* of, const char* function) const {
        if (work_.load(std::memory_order_relaxed) != 0) [[unlikely]]
            refuse_or_report(of, function);
    }
    /// Like `may_edit`, for a step, which is recorded in another way.
    void may_step() const {
        may_read();
        if (locked()) [[unlikely]]
            refuse_edit("World", "step");
    }
    /// Like `may_edit`, for creating, destroying or attaching objects. The call is not recorded.
    void may_populate(const char* of, const char* function) const {
        may_read();
        may_replace(of, function);
    }
    /// Like `may_populate`, for another state in place of this one, which may be damaged.
    void may_replace(const char* of, const char* function) const {
        if (locked()) [[unlikely]]
            refuse_edit(of, function);
        if (owner != nullptr && !owner->acts()) [[unlikely]]
            refuse_non_owner(of, function);
    }
    void may_copy(const char* what) const {
        may_read();
        if (in_the_middle()) [[unlikely]]
            refuse_copy(what);
    }
    void may_read() const {
        if (damaged()) [[unlikely]]
            throw_damaged();
    }
    [[noreturn]] static void throw_damaged();

    /// Sets the observer, which receives all changes of the world; null: none.
    void set_observer(std::unique_ptr<WorldObserver> observer);
    WorldObserver* observer() const { return observer_.get(); }
    /// Passes the answer of a user function in a step to a recording.
    void record_answer(auto&& answer) const {
        if (observer_ != nullptr) [[unlikely]]
            observer_->answered(answer());
    }

    /// Calls a user function in a step or an edit, which an exception must not interrupt: the first
    /// exception is stored until `WorldLock::finish`. False if it threw, or if user functions may
    /// not be called any more.
    bool call_user(const char* callback, auto&& call) const {
        if (orphaned()) return false;
        const char* const outer = enter(callback);
        bool answered = true;
        try {
            call();
        } catch (...) {
            if (!thrown_) thrown_ = std::current_exception();
            answered = false;
        }
        set_operation(outer);
        return answered && !orphaned();
    }
    /// Makes the calls 0 … `count` - 1 as `call_user` does, on these threads; null: in order on
    /// this one. The first exception is that of the lowest number.
    void call_user_for_all(const char* callback, ThreadPool* threads, uint32_t count, auto&& call,
                           std::vector<char>& answered) const {
        if (threads == nullptr) {
            for (uint32_t i = 0; i < count; ++i)
                answered[i] = call_user(callback, [&] { call(i); });
            return;
        }
        const char* const outer = enter(callback);
        std::mutex mutex;
        std::exception_ptr thrown;
        size_t first = count;
        parallel_for(threads, count, 32, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
                answered[i] = true;
                try {
                    call(uint32_t(i));
                } catch (...) {
                    answered[i] = false;
                    const std::lock_guard lock(mutex);
                    if (i < first) first = i, thrown = std::current_exception();
                }
            }
        });
        if (thrown && !thrown_) thrown_ = thrown;
        set_operation(outer);
        if (orphaned()) std::fill(answered.begin(), answered.end(), char(false));
    }
    /// Called if a function that the World is calling destroys it: the data live until that call is
    /// over.
    void keep_alive(Owned<WorldData> data);
    [[noreturn]] void throw_orphaned() const;

  private:
    friend class WorldLock;
    static constexpr uint32_t middle = 1u << 16;
    /// Is set in `work_` while there is an observer, so that one test finds both.
    static constexpr uint32_t watched = 1u << 31;
    /// Likewise while the state is damaged.
    static constexpr uint32_t damage = 1u << 30;
    static constexpr uint32_t marks = watched | damage;
    void refuse_or_report(const char* of, const char* function) const;
    [[noreturn]] void refuse_edit(const char* of, const char* function) const;
    [[noreturn]] void refuse_non_owner(const char* of, const char* function) const;
    [[noreturn]] void refuse_copy(const char* what) const;
    const char* operation() const { return inside_.load(std::memory_order_relaxed); }
    const char* enter(const char* callback) const {
        const char* const outer = operation();
        set_operation(callback);
        return outer;
    }
    void set_operation(const char* outer) const { inside_.store(outer, std::memory_order_relaxed); }

    /// A query, of which several threads may make some, counts 1; a step or an edit counts
    /// `middle`.
    mutable std::atomic<uint32_t> work_ = 0;
    mutable std::atomic<const char*> inside_ = in_step;  ///< the running operation, for messages
    mutable std::exception_ptr thrown_;                  ///< first one of a user function
    mutable Owned<WorldData> orphan_;
    std::unique_ptr<WorldObserver> observer_;
    const char* destroyed_inside_ = nullptr;
};

/// While it lives, user functions may be called: the world cannot be edited, and its data stay
/// alive if one of those functions destroys it.
class WorldLock {
  public:
    enum class During { query, change };
    WorldLock(const WorldSelf& self, During during, const char* inside);
    ~WorldLock();
    WorldLock(const WorldLock&) = delete;
    WorldLock& operator=(const WorldLock&) = delete;

    /// At the end of a change: throws the stored exception of a user function. At the end of any
    /// operation: throws Locked if a user function destroyed the world.
    void finish();

  private:
    void unlock();

    const WorldSelf* self_;  ///< null: unlocked
    uint32_t weight_;
    const char* outer_;
};

}  // namespace fettle::physics::detail
