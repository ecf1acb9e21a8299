#pragma once
// Things due at a moment of simulation time: functions given to `after` and `every`, and coroutines
// in `wait`.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include <calls/function_ref.h>
#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;
class FunctionRef;

class Timers {
  public:
    explicit Timers(Machine& machine) : machine_(machine) {}

    double now = 0;  // simulation time, seconds

    /// The function on top of `L`, taken. `interval` below 0: once. Returns the timer's number.
    std::uint64_t add(lua_State* L, double due, double interval);
    /// `L` itself, resumed at `due`.
    void wait(lua_State* L, double due);
    void stop(std::uint64_t id);
    bool active(std::uint64_t id) const { return due_.contains(id); }
    bool waiting(lua_State* thread) const { return waiting_.contains(thread); }
    /// Runs everything due by now, in order of time, then of creation. False when one raised.
    bool run();
    void clear();
    std::size_t size() const { return queue_.size(); }

    // Snapshots. Functions are restored; a coroutine that waits is where it is now, and goes on
    // waiting as long as it still had to.
    struct Timer {
        double interval = -1;
        std::shared_ptr<FunctionRef> function;  // null: a thread that waits
        int thread = LUA_NOREF;
    };
    using Key = std::pair<double, std::uint64_t>;  // due, number
    using Queue = std::map<Key, Timer>;
    struct Change {
        Key key;
        std::optional<Timer> added;  // else removed
    };
    /// What has been added and removed since the last call, in order; the first call begins it.
    /// `all`: so much that the whole queue is told instead.
    struct Changes {
        bool all = false;
        Queue queue;
        std::vector<Change> list;
        bool empty() const { return !all && list.empty(); }
    };
    Queue image() const;
    /// `later`: by how much simulation time jumps, seconds.
    void restore(const Queue& image, double later);
    Changes take_changes();
    /// Memory they take, about; functions count where they were added.
    static std::size_t bytes_of(const Queue& image);
    static std::size_t bytes_of(const Changes& changes);
    void redo(const Changes& changes);

  private:
    bool fire(const Timer& timer);
    int take_thread();

    void insert(const Key& key, Timer timer);
    void erase(Queue::iterator entry);
    void note(Change change);

    Machine& machine_;
    Queue queue_;
    Changes changes_;
    bool noting_ = false;
    std::unordered_map<std::uint64_t, double> due_;
    std::unordered_map<lua_State*, std::uint64_t> waiting_;
    std::vector<int> idle_;  // threads that finished, ready for the next function
    std::uint64_t next_id_ = 1;
};

/// `after every wait` into the table of globals on top.
void open_timers(lua_State* L);

}  // namespace fettle::script
