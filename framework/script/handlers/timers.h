#pragma once
// Timers in simulation time: functions given to `after` and `every`, and coroutines in `wait`.

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <fettle/property/value.h>

#include <calls/function_ref.h>
#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;
class FunctionRef;

class Timers {
  public:
    explicit Timers(Machine& machine) : machine_(machine) {}

    double now = 0;  // simulation time, seconds

    /// Adds the function at the top of the stack `L` and pops it. It is due in `seconds`.
    /// `interval` below 0: called once.
    /// With an `owner`, the timer ends when that is deleted, and the function gets it as argument.
    /// A timer that `enter` of a scene adds ends with the scene, too.
    /// Returns the timer's number.
    std::uint64_t add(lua_State* L, double seconds, double interval, property::Handle owner = {});
    /// The same for a timer of a file, which is due at a simulation time and belongs to `scene`,
    /// too.
    void add_at(lua_State* L, double due, double interval, property::Handle owner,
                property::Handle scene);
    /// The same in real time, in `seconds`: it continues while the game is paused, and is in no
    /// snapshot.
    std::uint64_t add_real(lua_State* L, double seconds, double interval, property::Handle owner);
    /// Runs the function at the top of the stack `L` as a coroutine that ends with `owner`, which
    /// is its argument, and replaces it by the thread. Raises its error.
    void start(lua_State* L, property::Handle owner);
    /// Resumes the coroutine `L` after that time: real time if a timer in real time has begun it.
    void wait(lua_State* L, double seconds);
    void stop(std::uint64_t id);
    bool active(std::uint64_t id) const;
    bool waiting(lua_State* thread) const { return waiting_.contains(thread); }
    /// Runs all timers that are due, in order of time, then of creation. Returns false if one
    /// raised an error.
    bool run();
    /// The same for timers in real time, `seconds` after the last picture.
    bool advance_real(double seconds);
    void clear();
    std::size_t size() const { return queue_.size() + parked_.size() + real_.size(); }

    // Notes the timers that the top level of a game starts: a reload replaces them.
    void begin_noting() { noting_top_ = true; }
    struct Noted {
        std::uint64_t id = 0;
        double delay = 0;        // s, as the script gave it
        double interval = -1;    // s; below 0: once
        int thread = LUA_NOREF;  // reference of a coroutine that waited; the other members are not
                                 // used then
    };
    std::vector<Noted> end_noting();
    /// Ends a timer, or a coroutine if it waits.
    void end(const Noted& noted);
    /// The coroutine waits no longer and is not continued; no effect if it does not wait.
    void end_waiting(lua_State* thread);
    /// The timer `by` is due when `old` would be, which ends. If `old` has ended, so does `by`.
    void replace(const Noted& old, const Noted& by);
    /// From now on no restore starts this timer again, because a reload has replaced its code.
    void retire(const Noted& noted) { retired_.insert(noted.id); }
    /// The instances with whose deletion timers end.
    std::vector<property::Handle> owners() const;
    /// Makes the timers of `from` those of `to`.
    void change_owner(property::Handle from, property::Handle to);

    // Snapshots. Functions are restored. A coroutine that has waited since the restored step waits
    // on, until the same time; one that has run since keeps its current state and its remaining
    // time; one that began later does not continue.
    struct Timer {
        double interval = -1;
        std::shared_ptr<FunctionRef> function;  // null: a waiting thread
        int thread = LUA_NOREF;
        property::Handle owner{};  // empty: the game
        property::Handle scene{};  // whose `enter` began it
        bool top = false;          // of the top level of the game
        std::uint64_t begun = 0;   // of a thread: the next number of a timer when it began
        bool real = false;         // in real time
    };
    using Key = std::pair<double, std::uint64_t>;  // time at which it is due, number
    using Queue = std::map<Key, Timer>;
    struct Change {
        Key key;
        std::optional<Timer> added;  // nullopt: removed
    };
    /// Additions and removals since the last call, in order; the first call starts recording.
    /// `all`: there were too many changes, so `queue` is the whole queue.
    struct Changes {
        bool all = false;
        Queue queue;
        std::vector<Change> list;
        std::uint64_t next = 0;  // the number of the next timer
        bool empty() const { return !all && list.empty(); }
    };
    Queue image() const;
    std::uint64_t next_number() const { return next_id_; }
    /// Restores the timers of the simulation time `to`. `next`: the number of the next timer at
    /// that time; the largest number if it is unknown.
    void restore(const Queue& image, double to, std::uint64_t next);
    /// The same for a snapshot from a file, which contains no functions: timers of the top level of
    /// the game, and coroutines, continue for the rest of their time, and other timers end.
    void restore_from_file(double to);
    Changes take_changes();
    /// How many there are, and where the functions of the first few of them are defined.
    struct Places {
        std::uint64_t count = 0;
        std::vector<std::string> places{};
        std::string listed() const;  ///< "main.lua:3, main.lua:7"
    };
    /// Timers that `restore_from_file` would end, without those with these numbers.
    Places ending(const std::unordered_set<std::uint64_t>& stay) const;
    /// Waiting coroutines that the top level of the game has not begun: no file contains them.
    Places coroutines() const;
    /// Estimated bytes, without the functions; these are counted where they were added.
    static std::size_t bytes_of(const Queue& image);
    static std::size_t bytes_of(const Changes& changes);
    void redo(const Changes& changes, double to);

  private:
    /// A waiting coroutine after the game went back in time. Until the next step, the game may
    /// return to a later step. The next step continues the coroutine if it had begun at the current
    /// step, and ends it otherwise.
    struct Parked {
        double due = 0, rest = 0;  // s: the simulation time for which it waits, and how long still
        std::uint64_t id = 0;
        Timer timer;
    };
    void park();
    void unpark();
    /// Notes, once, which coroutines could not go back in time: those that go on where they were,
    /// and the number of those that had ended since.
    void tell_of_coroutines(const Places& running, std::uint64_t ended);
    void add_place(Places& to, std::string place) const;
    std::string place_of(const Timer& timer) const;
    /// A timer or a waiting coroutine in real time.
    struct Real {
        double rest = 0;  // s
        Timer timer;
    };
    using Reals = std::map<std::uint64_t, Real>;  // by number
    bool run_real(std::uint64_t id);
    /// A timer or a coroutine ends when one of these is deleted; a null handle never is.
    struct Lifetime {
        property::Handle owner{};
        property::Handle scene{};
        std::uint64_t begun = 0;
        bool real = false;
        bool top = false;
    };
    /// A coroutine that has waited and ended: the number of the next timer when it began, and the
    /// simulation time of its end.
    struct Ended {
        std::uint64_t begun = 0;
        double at = 0;
    };

    Timer made(lua_State* L, double interval, property::Handle owner);
    bool fire(const Timer& timer);
    bool ended(const Timer& timer) const;
    void forget(const Timer& timer);
    int idle_thread();
    /// Resumes a thread that may wait again.
    void resume(lua_State* L, lua_State* thread, int arguments, Lifetime lifetime);
    void note_yield(lua_State* thread);

    void insert(const Key& key, Timer timer);
    void erase(Queue::iterator entry);
    void note(Change change);

    // s; sums of steps have rounding errors, so timers that are due this soon after a step's end
    // count as due.
    static constexpr double tolerance = 1e-9;
    static constexpr std::int64_t weight_of_timer = 300;  // bytes, estimated

    Machine& machine_;
    Queue queue_;
    Changes changes_;
    bool noting_ = false;
    std::unordered_map<std::uint64_t, double> due_;
    std::unordered_map<lua_State*, std::uint64_t> waiting_;
    std::unordered_map<lua_State*, Lifetime> lifetimes_;  // of threads that run or wait
    std::unordered_set<std::uint64_t> retired_;
    std::vector<Parked> parked_;
    std::deque<Ended> ended_;  // the last ones
    bool from_file_ = false;   // its simulation time is that of another run
    bool returned_ = false;  // the game is in the state of another step, and has made no step there
    bool told_ = false;
    bool noted_yield_ = false;
    Reals real_;
    double parked_until_ = 0;        // s, simulation time of the restored step
    std::uint64_t parked_from_ = 0;  // the number of the next timer at the restored step
    std::vector<int> idle_;          // finished threads, for reuse
    std::uint64_t next_id_ = 1;
    bool noting_top_ = false;
    std::vector<Noted> noted_;
};

/// Adds `after`, `every` and `wait` to the table of globals at the top of the stack.
void open_timers(lua_State* L);

// Methods of every instance: self, then the arguments of the functions. `run` takes a function.
int after_of_instance(lua_State* L);
int every_of_instance(lua_State* L);
int run_of_instance(lua_State* L);

}  // namespace fettle::script
