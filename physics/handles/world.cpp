// Methods of a world: settings, creation and lists of objects.

#include <checks/arguments.h>
#include <checks/hooks.h>
#include <contacts/mixing.h>
#include <contacts/reports.h>
#include <fettle/physics/instruction_set.h>
#include <fettle/physics/version.h>
#include <geometry/trigonometry.h>
#include <world/world_data.h>

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

namespace fettle::physics {

using namespace detail;

namespace {

/// The worlds whose functions of `after_step` are being called in this thread, the innermost first.
/// A later world may have the same address and the same link, so neither shows whether the first
/// world still exists.
struct CallsAfterStep {
    const WorldData* world;
    CallsAfterStep* outer;
    bool destroyed = false;

    explicit CallsAfterStep(const WorldData* of) : world(of), outer(innermost) { innermost = this; }
    ~CallsAfterStep() { innermost = outer; }
    CallsAfterStep(const CallsAfterStep&) = delete;
    CallsAfterStep& operator=(const CallsAfterStep&) = delete;

    static void end(const WorldData* world) {
        for (CallsAfterStep* calls = innermost; calls != nullptr; calls = calls->outer)
            if (calls->world == world) calls->destroyed = true;
    }

  private:
    static thread_local CallsAfterStep* innermost;
};
thread_local CallsAfterStep* CallsAfterStep::innermost = nullptr;

}  // namespace

World::World(const WorldDef& def) {
    check(def);
    data_ = detail::Owned(new WorldData);
    data_->self.link = &acquire_link();  // returned together with the data
    data_->settings = def;
    detail::make_border(data_->editing());
    begin();
}

/// Publishes the data for handles.
void World::begin() {
    columns_ = data_.get();
    link_ = data_->self.link;
    link_->world = this;
    link_->data = data_.get();
}

World::~World() {
    if (!data_) return;  // its data were moved to another World
    CallsAfterStep::end(data_.get());
    link_->world = nullptr;
    link_->data = nullptr;
    WorldSelf& self = data_->self;
    if (self.locked()) self.keep_alive(std::move(data_));
}

// NOLINTNEXTLINE(performance-noexcept-move-constructor): a callback may not move its world
World::World(World&& other) {
    *this = std::move(other);
}

/// The data are moved, so handles stay valid.
// NOLINTNEXTLINE(performance-noexcept-move-constructor): a callback may not replace its world
World& World::operator=(World&& other) {
    if (this == &other) return *this;
    if (data_) data_->self.may_replace("World", "operator=");
    other.populate("operator=");
    World empty;
    // Destroyed last: objects that its functions own may use this world.
    const detail::Owned<WorldData> old = std::move(data_);
    if (old) {
        CallsAfterStep::end(old.get());
        link_->world = nullptr;
        link_->data = nullptr;
    }
    data_ = std::move(other.data_);
    begin();
    other.data_ = std::move(empty.data_);
    other.begin();
    return *this;
}

World World::clone() const {
    return World(*this);
}

World::World(const World& other) {
    other.data_->self.may_copy("copying a World");
    data_ = detail::Owned(new WorldData);
    data_->self.link = &acquire_link();
    data_->most_width = other.data_->most_width;
    data_->replace_state(WorldState(static_cast<const WorldState&>(*other.data_)));
    begin();
}

void World::restore(const World& other) {
    if (this == &other) return;
    data_->self.may_replace("World", __func__);
    WorldData& data = *data_;
    other.data_->self.may_copy("copying a World");
    data.replace_state(WorldState(static_cast<const WorldState&>(*other.data_)));
}

void World::set_owner(const Owner* owner) {
    edit(__func__).self.owner = owner;
}

WorldData& World::edit(const char* function) const {
    data_->self.may_edit("World", function);
    return *data_;
}

WorldData& World::populate(const char* function) const {
    data_->self.may_populate("World", function);
    return edit(function);
}

namespace {

/// Reports the first fault of a world to the host, if the host has switched this check on.
void check_after_step(const World& world) {
    if (!are_steps_checked()) return;
    const auto fault = world.validate();
    const FailureHook hook = failure_hook();
    if (fault && hook.function != nullptr) hook.function(hook.user, world, fault->c_str());
}

void log_invalid_step(float dt) {
    if (dt == 0.0f) return;
    log(LogLevel::warning,
        "World::step: dt = " + std::to_string(dt) + ": no step is made, expected seconds above 0");
}

}  // namespace

void World::step(float dt) {
    WorldData& data = *data_;
    data.self.may_step();
    if (!(dt > 0.0f) || !(dt < infinity)) return log_invalid_step(dt);
    WorldLock lock(data.self, WorldLock::During::change, in_step);
    // If the host's threads are not available, this throws: nothing was done, and no recording has
    // a step.
    ThreadPool::HostThreads host_threads(data.threads);
    if (data.self.observer() != nullptr) {
        data.read_all();  // objects that a refresh creates get the ids of this world, not of a
                          // replay
        data.notify_step_begin(dt);
    }
    try {
        data.step(dt);
    } catch (...) {  // exceptions of callbacks do not get here: memory ran out
        data.mark_damaged_and_rethrow();
    }
    const std::exception_ptr failure_of_host = host_threads.finish();
    if (!data.self.functions.empty()) data.call_position_functions(dt);
    if (data.self.observer() != nullptr) data.notify_step_end();
    if (data.self.after_step.empty() || data.self.orphaned()) {
        lock.finish();
        check_after_step(*this);
    } else {
        call_after_step(std::exchange(data.self.after_step, {}), lock);
    }
    if (failure_of_host) std::rethrow_exception(failure_of_host);
}

/// The functions may destroy the world.
void World::call_after_step(std::vector<Function<void()>> calls, WorldLock& lock) const {
    const CallsAfterStep running(data_.get());
    std::exception_ptr first;
    const auto attempt = [&first](auto&& call) {
        try {
            call();
        } catch (...) {
            if (first)
                log(LogLevel::error,
                    "World::step: a function of after_step threw, too; the step throws the first "
                    "exception only");
            else
                first = std::current_exception();
        }
    };
    attempt([&] { lock.finish(); });
    if (!running.destroyed) attempt([&] { check_after_step(*this); });
    for (const Function<void()>& call : calls)
        if (!running.destroyed) attempt(call);
    if (first) std::rethrow_exception(first);
}

void World::after_step(Function<void()> act) const {
    if (data_->self.calling_in_parallel)
        throw Locked(
            "World::after_step was called inside a callback that may run on several threads "
            "(World::set_parallel_callbacks), so the order of the functions would be unknown");
    if (act) data_->self.after_step.push_back(std::move(act));
}

void World::reserve(const Capacity& capacity) {
    constexpr uint32_t most = 1u << 24;
    WorldData& data = edit(__func__);
    const auto checked = [](const char* what, uint32_t count) {
        if (count > most)
            throw std::invalid_argument(std::string(what) + " = " + std::to_string(count) +
                                        ": expected at most " + std::to_string(most));
        return count;
    };
    const auto each = [](uint32_t count, auto&... lists) { (lists.reserve(count), ...); };
    // The first body and the first four shapes are those of the bounds.
    const uint32_t bodies = checked("bodies", capacity.bodies) + 1;
    const uint32_t shapes = checked("shapes", capacity.shapes) + 4;
    const uint32_t contacts = checked("contacts", capacity.contacts);
    const uint32_t joints = checked("joints", capacity.joints);
    each(bodies, data.bodies, data.rest_poses, data.states, data.previous, data.body_generations,
         data.awake_bodies, data.edited_bodies);
    each(shapes, data.shapes, data.forms, data.boxes, data.fat_boxes, data.paired_boxes,
         data.shape_generations, data.edited_shapes, data.moved_shapes);
    each(contacts, data.contacts, data.contact_links, data.manifold_poses, data.awake_contacts);
    each(joints, data.joints, data.joint_generations);
}

// Defines a setting that is checked before it is written; `then`: further effects of the change.
#define FETTLE_WORLD_SETTING(Value, Argument, name, checked, then) \
    Value World::name() const {                                    \
        return data_->settings.name;                               \
    }                                                              \
    void World::set_##name(Argument value) {                       \
        WorldData& data = edit(__func__);                          \
        data.settings.name = checked;                              \
        then;                                                      \
    }
#define FETTLE_WORLD_NUMBER(name, check, then) \
    FETTLE_WORLD_SETTING(float, float, name, check(#name, value), then)

FETTLE_WORLD_SETTING(Vec2, const Vec2&, gravity, check_finite("gravity", value),
                     data.change<detail::wake_all>())
FETTLE_WORLD_SETTING(int, int, substeps, check_count("substeps", value, 1, 64), )
int World::last_substeps() const {
    return data_->last_substeps;
}
FETTLE_WORLD_SETTING(const std::optional<Aabb>&, const std::optional<Aabb>&, bounds,
                     value ? check_box("bounds", *value) : value,
                     data.change<detail::apply_bounds>())
FETTLE_WORLD_NUMBER(bounds_friction, check_not_negative, data.change<detail::apply_bounds>())
FETTLE_WORLD_SETTING(float, float, bounds_restitution,
                     check_range("bounds_restitution", value, 0.0f, 1.0f),
                     data.change<detail::apply_bounds>())
FETTLE_WORLD_SETTING(bool, bool, sleeping, value, if (!value) data.change<detail::wake_all>())
FETTLE_WORLD_SETTING(bool, bool, continuous, value, )
FETTLE_WORLD_NUMBER(restitution_threshold, check_not_negative, )
FETTLE_WORLD_NUMBER(hit_threshold, check_not_negative, )
FETTLE_WORLD_NUMBER(sleep_speed, check_not_negative, data.change<detail::wake_all>())
FETTLE_WORLD_NUMBER(sleep_delay, check_not_negative, data.change<detail::wake_all>())
FETTLE_WORLD_NUMBER(contact_hertz, check_not_negative, data.change<detail::wake_all>())
FETTLE_WORLD_NUMBER(contact_damping, check_not_negative, data.change<detail::wake_all>())
FETTLE_WORLD_NUMBER(push_speed, check_not_negative, data.change<detail::wake_all>())
FETTLE_WORLD_NUMBER(max_speed, check_speed_limit, )
FETTLE_WORLD_SETTING(MixRule, MixRule, friction_mix,
                     check_enumerator("friction_mix", value, MixRule::geometric), remix_all(data);
                     data.change<detail::wake_all>())
FETTLE_WORLD_SETTING(MixRule, MixRule, restitution_mix,
                     check_enumerator("restitution_mix", value, MixRule::geometric),
                     remix_all(data);
                     data.change<detail::wake_all>())
FETTLE_WORLD_SETTING(bool, bool, persist_events, value, )
FETTLE_WORLD_SETTING(Solver, Solver, solver, check_enumerator("solver", value, Solver::direct),
                     data.change<detail::wake_all>())

int World::threads() const {
    return data_->self.pool ? data_->self.pool->threads() : 1;
}
void World::set_threads(int threads) {
    WorldData& data = edit(__func__);
    check_count("threads", threads, 1, 64);
    const bool own = !data.self.pool || !data.self.pool->has_host();
    if (own && threads == this->threads()) return;
    data.self.pool = threads > 1 ? std::make_unique<ThreadPool>(threads) : nullptr;
    data.threads = data.self.pool.get();
    if (threads > processors() && is_logged())
        log(LogLevel::note, "World::set_threads: threads = " + std::to_string(threads) +
                                ": only as many work at a time as there are processors, " +
                                std::to_string(processors()));
}

void World::set_scheduler(TaskScheduler* scheduler, int threads) {
    WorldData& data = edit(__func__);
    check_count("threads", threads, 1, 64);
    data.self.pool = scheduler != nullptr && threads > 1
                         ? std::make_unique<ThreadPool>(*scheduler, threads)
                         : nullptr;
    data.threads = data.self.pool.get();
}

int version() noexcept {
    return FETTLE_PHYSICS_VERSION;
}

int simd_width() {
    return detail::wide_kernels().width;
}
void World::limit_simd_width(int most) {
    WorldData& data = edit(__func__);
    data.most_width = detail::check_simd_width("most", most);
}

void World::wake_all() {
    edit(__func__).change<detail::wake_all>();
}

bool World::is_recorded() const {
    return data_->self.observer() != nullptr;
}
void World::stop_recording() {
    edit(__func__).self.set_observer(nullptr);
}

Body World::create_body(const BodyDef& def) {
    WorldData& data = populate(__func__);
    check(def);
    detail::make_room_for_body(data.editing());
    return {this, data.body_id(data.change<detail::create_body>(def))};
}

Shape World::create_shape(const Geometry& geometry, const ShapeDef& def) {
    WorldData& data = populate(__func__);
    check(def);
    check(geometry);
    detail::make_room_for_shape(data.editing(), geometry);
    return {this, data.shape_id(data.change<detail::create_shape>(def, geometry))};
}

void World::clear() {
    populate(__func__);
    for (Body b : bodies()) b.destroy();
    for (Shape s : shapes()) s.destroy();
    for (Joint j : joints()) j.destroy();  // dormant ones
    for (Field f : fields()) f.destroy();
}

namespace {

/// Handles of the used slots from `first` on for which `wanted` is true.
template <class Handle, class Id>
std::vector<Handle> handles(World* world, const std::vector<uint32_t>& generations, uint32_t first,
                            const auto& wanted) {
    std::vector<Handle> all;
    for (uint32_t i = first; i < generations.size(); ++i)
        if (generations[i] != 0 && wanted(i)) all.emplace_back(world, Id{i, generations[i]});
    return all;
}

bool any(uint32_t) {
    return true;
}

}  // namespace

std::vector<Body> World::bodies() const {
    return handles<Body, BodyId>(self(), data_->body_generations, 1, any);
}
/// A body that fell asleep in the step rested before, so its pose did not change in a visible way.
std::vector<Body> World::moved_bodies() const {
    data_->self.may_read();
    std::vector<uint32_t> slots;
    for (const uint32_t body : data_->awake_bodies) {
        const BodyState& now = data_->states[body];
        const Pose& before = data_->previous[body];
        if (now.position != before.position || now.angle != before.angle) slots.push_back(body);
    }
    std::sort(slots.begin(), slots.end());
    std::vector<Body> moved;
    moved.reserve(slots.size());
    for (const uint32_t body : slots) moved.emplace_back(self(), data_->body_id(body));
    return moved;
}

std::vector<Shape> World::shapes() const {
    const auto whole = [&](uint32_t shape) { return data_->shapes[shape].owner == none; };
    return handles<Shape, ShapeId>(self(), data_->shape_generations, 4, whole);
}
std::vector<Joint> World::joints() const {
    return handles<Joint, JointId>(self(), data_->joint_generations, 0, any);
}

std::vector<Contact> World::contacts() const {
    data_->self.may_read();
    std::vector<Contact> all;
    for (const ContactRecord& c : data_->contacts) {
        if (c.touching && !c.sensor) all.push_back(view_of(*data_, *data_, data_->last_substep, c));
    }
    return all;
}

bool World::is_touching(const ContactId& id) const {
    return data_->is_valid(id.shape_a) && data_->is_valid(id.shape_b) &&
           touch(*data_, id.shape_a.index, id.shape_b.index);
}

std::vector<Contact> World::contacts_of(const ContactId& id) const {
    std::vector<Contact> all;
    if (!is_touching(id)) return all;
    data_->for_each_contact(data_->forms[id.shape_a.index].body, [&](uint32_t slot) {
        const ContactRecord& c = data_->contacts[slot];
        const ContactId here =
            ContactId::of(data_->shape_id(c.shape_a), data_->shape_id(c.shape_b));
        if (c.touching && !c.sensor && here == ContactId::of(id.shape_a, id.shape_b))
            all.push_back(view_of(*data_, *data_, data_->last_substep, c));
    });
    return all;
}

bool World::locked() const {
    return data_->self.locked();
}

// A damaged world has no objects, although slots of the incomplete state are in use.
uint32_t World::body_count() const {
    return data_->self.damaged() ? 0 : data_->body_slots.count;
}
uint32_t World::shape_count() const {
    return data_->self.damaged() ? 0 : data_->shape_slots.count;
}
uint32_t World::joint_count() const {
    return data_->self.damaged() ? 0 : data_->joint_slots.count;
}
const Events& World::events() const {
    return data_->events;
}
const StepStatistics& World::statistics() const {
    return data_->statistics;
}

}  // namespace fettle::physics
