#pragma once

#include <fettle_physics.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "call_memory.h"
#include "numbers.h"

// Arguments for functions in C: valid ones and invalid ones. Pointers are null or point to
// enough memory, as the headers demand; all numbers may be anything.

namespace random_arguments {

class Arguments {
  public:
    explicit Arguments(Numbers numbers) : random_(std::move(numbers)) {
        for (auto& world : worlds_) fettle_world_create(nullptr, &world);
        fettle_world_destroy(worlds_[3]);  // a stale pointer
        fettle_owner_create("ask the owner", &owner_);
        fettle_replay_create(recording().data(), recording().size(), &replay_);
    }
    ~Arguments() {
        for (fettle_world* world : worlds_) fettle_world_destroy(world);
        while (fettle_owner_end(owner_) == FETTLE_DONE) {
        }
        fettle_owner_destroy(owner_);
        fettle_replay_destroy(replay_);
        fettle_set_log(nullptr, nullptr);
        fettle_set_failure_function(nullptr, nullptr);
    }
    Arguments(const Arguments&) = delete;
    Arguments& operator=(const Arguments&) = delete;

    uint32_t below(uint32_t count) { return random_.below(count); }
    /// True if the input that chooses the arguments has ended.
    bool ended() const { return random_.ended(); }

    /// Calls a function with arguments of the types that it has, and checks what it made.
    template <class Result, class... Parameters>
    void call(Result (*function)(Parameters...)) {
        CallMemory& made = memory();
        made.world = nullptr;
        made.owner = nullptr;
        made.replay = nullptr;
        const std::tuple<Parameters...> given{make<Parameters>()...};
        const CallMemory::Results before = made.results();
        [[maybe_unused]] const Result result = std::apply(function, given);
        if constexpr (std::is_same_v<Result, fettle_code>)
            if (result != FETTLE_DONE && made.results() != before) wrote_after_error_ = true;
        after_call();
    }
    /// Whether a function has written results and then returned another code than FETTLE_DONE.
    bool wrote_after_error() const { return wrote_after_error_; }
    /// Checks and destroys what a call made.
    void after_call() {
        if (depth_ == 0) calls_inside_ = 0;
        CallMemory& made = memory();
        if (made.owner != nullptr) fettle_owner_destroy(made.owner);
        fettle_replay_destroy(made.replay);
        if (made.world != nullptr) {
            fettle_world*& place = worlds_[below(3)];
            if (fettle_world_destroy(place) == FETTLE_DONE)
                place = made.world;
            else
                fettle_world_destroy(made.world);  // `place` is not destroyed inside its own call
        }
        bool locked;
        for (int i = 0; i < 3; ++i)
            if (fettle_world_locked(worlds_[i], &locked) == FETTLE_STALE)
                fettle_world_create(nullptr, &worlds_[i]);  // it was destroyed by the call
        remember_ids();
    }

    const fettle_world* world(int i) const { return worlds_[i]; }
    fettle_world* world(int i) { return worlds_[i]; }

    /// Restores what a world saved, sometimes with a changed byte or without its end.
    void restore() {
        const void* bytes = nullptr;
        size_t size = 0;
        if (fettle_world_save(worlds_[below(3)], &bytes, &size) != FETTLE_DONE) return;
        const auto changed = damaged(bytes, size);
        fettle_world_restore(worlds_[below(3)], changed.data(), changed.size());
    }
    /// The same with a recording.
    void replay() {
        const auto changed = damaged(recording().data(), recording().size());
        fettle_replay* made = nullptr;
        if (fettle_replay_create(changed.data(), changed.size(), &made) != FETTLE_DONE) return;
        if (below(2) == 0) std::swap(made, replay_);
        fettle_replay_destroy(made);
    }

  private:
    static constexpr uint32_t most = 9;

    static const std::vector<std::byte>& recording() {
        static const std::vector<std::byte> recorded = [] {
            std::vector<std::byte> bytes;
            fettle_world* world = nullptr;
            fettle_world_create(nullptr, &world);
            fettle_world_create_body(world, nullptr, nullptr);
            fettle_world_start_recording(world, record, &bytes);
            for (int i = 0; i < 9; ++i) fettle_world_step(world, 0.02f);
            fettle_world_destroy(world);
            return bytes;
        }();
        return recorded;
    }
    std::vector<std::byte> damaged(const void* bytes, size_t size) {
        const auto* const begin = static_cast<const std::byte*>(bytes);
        std::vector<std::byte> copy(begin, begin + size);
        if (below(4) == 0) copy[below(uint32_t(size))] ^= std::byte{4};
        if (below(4) == 0) copy.resize(below(uint32_t(size)));
        return copy;
    }
    /// Makes a call inside a callback of another call; `user` points to the arguments.
    static void inside(void* user);

    template <class T>
    T make() {
        if constexpr (std::is_floating_point_v<T>)
            return number();
        else if constexpr (std::is_same_v<T, bool>)
            return below(2) == 0;
        else if constexpr (std::is_same_v<T, int32_t>)
            return below(8) == 0 ? int32_t(random_()) : int32_t(below(14)) - 1;
        else if constexpr (std::is_same_v<T, uint32_t>)
            return below(most);                           // a capacity, or a number of elements
        else if constexpr (std::is_same_v<T, fettle_id>)  // and size_t
            return id();
        else if constexpr (std::is_same_v<T, fettle_world*> ||
                           std::is_same_v<T, const fettle_world*>)
            return below(16) == 0 ? nullptr : worlds_[below(16) == 0 ? 3 : below(3)];
        else if constexpr (std::is_same_v<T, fettle_owner*> ||
                           std::is_same_v<T, const fettle_owner*>)
            return below(4) == 0 ? owner_ : nullptr;
        else if constexpr (std::is_same_v<T, fettle_replay*> ||
                           std::is_same_v<T, const fettle_replay*>)
            return below(4) == 0 ? nullptr : replay_;
        else if constexpr (std::is_function_v<std::remove_pointer_t<T>>)
            return callback(T());
        else if constexpr (std::is_pointer_v<T>)
            return below(12) == 0 ? nullptr : pointer(T());
    }

    float number() {
        constexpr float odd[] = {std::numeric_limits<float>::quiet_NaN(),
                                 std::numeric_limits<float>::infinity(),
                                 -std::numeric_limits<float>::infinity(),
                                 0.0f,
                                 1e-30f,
                                 1e8f,
                                 -3e38f};
        if (below(8) == 0) return odd[below(std::size(odd))];
        return (float(below(2001)) - 1000.0f) / (below(2) == 0 ? 1000.0f : 100.0f);
    }

    fettle_id id() {
        const uint32_t kind = below(10);
        if (kind == 0) return 0;
        if (kind == 1) return random_();
        if (ids_.empty()) return 1;
        fettle_id known = ids_[below(uint32_t(ids_.size()))];
        if (kind == 2) known ^= fettle_id(1) << below(64);
        return known;
    }

    // Functions that a world may call; they read it.
    static bool pass(void* user, const fettle_world* world, fettle_id a, fettle_id) {
        inside(user);
        float friction;
        return fettle_shape_friction(world, a, &friction) == FETTLE_DONE || a != 0;
    }
    static bool accept(void* user, const fettle_world* world, fettle_id shape) {
        inside(user);
        return fettle_world_step(const_cast<fettle_world*>(world), 1) == FETTLE_LOCKED &&
               fettle_shape_is_valid(world, shape);
    }
    /// A step inside a function that the world calls.
    static void refuse_step(const fettle_world* world) {
        if (fettle_world_step(const_cast<fettle_world*>(world), 1) != FETTLE_LOCKED) std::abort();
    }
    static void record(void* to, const fettle_world*, const void* bytes, size_t size) {
        const auto* begin = static_cast<const std::byte*>(bytes);
        auto& all = *static_cast<std::vector<std::byte>*>(to);
        all.insert(all.end(), begin, begin + size);
    }
    fettle_pair_filter callback(fettle_pair_filter) { return below(2) == 0 ? pass : nullptr; }
    fettle_contact_callback callback(fettle_contact_callback) {
        if (below(2) == 0) return nullptr;
        return [](void* user, const fettle_world*, fettle_contact_edit* contact) {
            inside(user);
            contact->friction = std::numeric_limits<float>::quiet_NaN();
            contact->restitution = 7;
        };
    }
    fettle_velocity_function callback(fettle_velocity_function) {
        if (below(2) == 0) return nullptr;
        return [](void* user, const fettle_world* world, fettle_velocity_edit* edit) {
            inside(user);
            refuse_step(world);
            edit->velocity = {std::numeric_limits<float>::quiet_NaN(), 1e30f};
        };
    }
    fettle_position_function callback(fettle_position_function) {
        if (below(2) == 0) return nullptr;
        return [](void* user, const fettle_world* world, fettle_position_edit* edit) {
            inside(user);
            refuse_step(world);
            edit->pose.position.x += 1;
            edit->pose.angle = std::numeric_limits<float>::infinity();
        };
    }
    fettle_log_function callback(fettle_log_function) {
        if (below(2) == 0) return nullptr;
        return [](void*, int32_t level, const char* text) {
            if (level < 0 || level > FETTLE_LOG_ERROR || text[0] == 0) std::abort();
        };
    }
    fettle_failure_function callback(fettle_failure_function) {
        if (below(8) > 0) return nullptr;  // checks are slow
        return [](void*, const char*) { std::abort(); };
    }
    fettle_recording_sink callback(fettle_recording_sink) {
        if (below(4) == 0) return nullptr;
        return [](void* user, const fettle_world* world, const void*, size_t) {
            inside(user);
            refuse_step(world);
        };
    }
    fettle_refresh_callback callback(fettle_refresh_callback) {
        if (below(2) == 0) return nullptr;
        return [](void* user, const fettle_world*, int32_t, uint32_t) { inside(user); };
    }
    fettle_after_step callback(fettle_after_step) {
        if (below(8) == 0) return nullptr;
        return [](void* user, fettle_world* world) {
            inside(user);
            fettle_world_create_body(world, nullptr, nullptr);
        };
    }
    fettle_start_tasks callback(fettle_start_tasks) {
        if (below(2) == 0) return nullptr;
        return [](void*, uint32_t, fettle_task, void*) {};  // no thread runs them
    }
    /// Also a fettle_finish_tasks.
    fettle_unlocked_callback callback(fettle_unlocked_callback) {
        if (below(2) == 0) return nullptr;
        return [](void* user) { inside(user); };
    }
    fettle_shape_visitor callback(fettle_shape_visitor) { return below(4) == 0 ? nullptr : accept; }
    fettle_ray_visitor callback(fettle_ray_visitor) {
        return [](void* user, const fettle_world*, const fettle_ray_hit* hit) {
            inside(user);
            return hit->fraction >= 0;
        };
    }

    // Pointers to input.
    const char* pointer(const char*) { return "text"; }
    const float* pointer(const float*) {
        return fill(memory().numbers, [this] { return number(); });
    }
    const fettle_line_point* pointer(const fettle_line_point*) {
        return fill(memory().line_points, [this] {
            return fettle_line_point{{number(), number()}, below(3), below(2) == 0};
        });
    }
    const fettle_movement* pointer(const fettle_movement*) {
        const auto pose = [this] { return fettle_pose{{number(), number()}, number()}; };
        return store(fettle_movement{pose(), pose(), {number(), number()}});
    }
    const fettle_vec2* pointer(const fettle_vec2*) {
        return fill(memory().points, [this] { return fettle_vec2{number(), number()}; });
    }
    const fettle_aabb* pointer(const fettle_aabb*) {
        return store(fettle_aabb{{number(), number()}, {number(), number()}});
    }
    const fettle_segment_surface* pointer(const fettle_segment_surface*) {
        return fill(memory().surfaces, [this] {
            return fettle_segment_surface{number(), number(), number(), number(), below(70000)};
        });
    }
    const fettle_mover_plane* pointer(const fettle_mover_plane*) {
        return fill(memory().planes, [this] {
            const float angle = number();
            return fettle_mover_plane{
                {std::cos(angle), std::sin(angle)}, {number(), number()}, number(), id()};
        });
    }
    const fettle_pose* pointer(const fettle_pose*) {
        return store(fettle_pose{{number(), number()}, number()});
    }
    const fettle_id* pointer(const fettle_id*) {
        return fill(memory().ids, [this] { return id(); });
    }
    fettle_world* const* pointer(fettle_world* const*) { return world_list(); }
    const fettle_world* const* pointer(const fettle_world* const*) { return world_list(); }
    const void* pointer(const void*) { return scratch(); }
    void* pointer(void*) { return this; }
    template <class Def>
    requires requires(const Def& def) { def.size; }
    const Def* pointer(const Def*) {
        std::byte* const bytes = room();
        Def& def = *reinterpret_cast<Def*>(bytes);
        begin(def);
        if (below(3) == 0) {
            // Any byte may be anything, also of members that should be true or false.
            for (uint32_t i = 0; i < 1 + below(6); ++i)
                bytes[below(sizeof def)] = std::byte(random_());
        }
        mend(def);
        return &def;
    }

    void begin(fettle_world_def& def) { fettle_world_def_init(&def, sizeof def); }
    void begin(fettle_body_def& def) {
        fettle_body_def_init(&def, sizeof def);
        def.position = {number(), number()};
    }
    void begin(fettle_shape_def& def) { fettle_shape_def_init(&def, sizeof def); }
#define FETTLE_BEGIN(type)                                \
    void begin(fettle_##type##_joint_def& def) {          \
        fettle_##type##_joint_def_init(&def, sizeof def); \
        def.body_a = id();                                \
        def.body_b = id();                                \
    }
    FETTLE_BEGIN(distance)
    FETTLE_BEGIN(revolute)
    FETTLE_BEGIN(prismatic)
    FETTLE_BEGIN(wheel)
    FETTLE_BEGIN(weld)
    FETTLE_BEGIN(motor)
    FETTLE_BEGIN(pulley)
    FETTLE_BEGIN(gear)
    FETTLE_BEGIN(groove)
    FETTLE_BEGIN(pin_slot)
    FETTLE_BEGIN(ratchet)
    FETTLE_BEGIN(filter)
    FETTLE_BEGIN(rotary_limit)
#undef FETTLE_BEGIN
    void begin(fettle_mouse_joint_def& def) {
        fettle_mouse_joint_def_init(&def, sizeof def);
        def.body = id();
    }
    void begin(fettle_field_def& def) {
        fettle_field_def_init(&def, sizeof def, int32_t(below(4)));
    }
    void begin(fettle_geometry& geometry) {
        fettle_geometry_init(&geometry, sizeof geometry, int32_t(below(7)));
    }
    void begin(fettle_join_options& options) {
        fettle_join_options_init(&options, sizeof options);
    }
    void begin(fettle_grid_layout& layout) {
        fettle_grid_layout_init(&layout, sizeof layout);
        layout.columns = below(4);
        layout.rows = below(4);
    }
    void begin(fettle_explosion_def& def) {
        fettle_explosion_def_init(&def, sizeof def);
        def.point = {number(), number()};
        def.falloff = std::abs(number());
    }
    void begin(fettle_mover_def& def) {
        fettle_mover_def_init(&def, sizeof def);
    }
    void begin(fettle_mover_state& state) {
        fettle_mover_state_init(&state, sizeof state);
        state.position = {number(), number()};
        state.on_ground = below(2) == 0;
        state.ground = id();
        state.dropped = id();
    }
    void begin(fettle_query_filter& filter) {
        fettle_query_filter_init(&filter, sizeof filter);
    }
    void begin(fettle_debug_draw& draw) {
        fettle_debug_draw_init(&draw, sizeof draw);
    }
    // Pointers in a definition must lead somewhere.
    template <class Def>
    void mend(Def&) {}
    void mend(fettle_body_def& def) {
        def.name = below(2) == 0 ? "crate" : nullptr;
    }
    void mend(fettle_geometry& geometry) {
        geometry.points = pointer(static_cast<const fettle_vec2*>(nullptr));
        geometry.point_count = below(most);
    }
    void mend(fettle_query_filter& filter) {
        filter.accept = below(2) == 0 ? accept : nullptr;
        filter.user = this;
    }
    void mend(fettle_debug_draw& draw) {
        draw.user = this;
        draw.polygon = nullptr;
        draw.color_of = nullptr;
        if (below(2) == 0)
            draw.color_of = [](void* user, const fettle_world* world, fettle_id body, fettle_id) {
                inside(user);
                refuse_step(world);
                return uint32_t(fettle_body_is_valid(world, body));
            };
        draw.circle = [](void* user, fettle_position, float, float, uint32_t) { inside(user); };
        draw.segment = [](void*, fettle_position, fettle_position, uint32_t) {};
        draw.point = [](void*, fettle_position, uint32_t) {};
    }

    // Pointers to results.
    fettle_world** pointer(fettle_world**) {
        return &memory().world;
    }
    fettle_owner** pointer(fettle_owner**) {
        return &memory().owner;
    }
    fettle_replay** pointer(fettle_replay**) {
        return &memory().replay;
    }
    template <class Out>
    requires(!std::is_const_v<Out> && !std::is_void_v<Out>) Out* pointer(Out*) {
        if constexpr (requires(Out out) { out.size; }) begin(*reinterpret_cast<Out*>(scratch()));
        return reinterpret_cast<Out*>(scratch());
    }
    /// Numbers of elements that are passed to functions are below `most`.
    template <class Value, size_t room, class Make>
    Value* fill(Value (&list)[room], const Make& make_one) {
        static_assert(most <= room);
        std::generate_n(list, most, make_one);
        return list;
    }
    /// Memory for one input; a call has at most four.
    std::byte* room() {
        CallMemory& of = memory();
        return of.inputs[of.next++ % std::size(of.inputs)];
    }
    std::byte* scratch() {
        return memory().scratch.data();
    }

    template <class Value>
    const Value* store(const Value& value) {
        std::byte* const bytes = room();
        std::memcpy(bytes, &value, sizeof value);
        return reinterpret_cast<const Value*>(bytes);
    }
    fettle_world** world_list() {
        return fill(memory().worlds, [this] { return worlds_[below(3)]; });
    }
    void remember_ids() {
        if (ids_.size() > 200) ids_.erase(ids_.begin(), ids_.begin() + 100);
        fettle_id found[4];
        uint32_t count = 0;
        const fettle_world* of = worlds_[below(3)];
        using List = fettle_code (*)(const fettle_world*, fettle_id*, uint32_t, uint32_t*);
        constexpr List lists[] = {fettle_world_bodies, fettle_world_shapes, fettle_world_joints,
                                  fettle_world_fields};
        if (lists[below(4)](of, found, 4, &count) != FETTLE_DONE) return;
        for (uint32_t i = 0; i < count && i < 4; ++i) ids_.push_back(found[i]);
    }

    CallMemory& memory() {
        return memory_[depth_];
    }

    Numbers random_;
    fettle_world* worlds_[4] = {};
    fettle_owner* owner_ = nullptr;
    fettle_replay* replay_ = nullptr;
    std::vector<fettle_id> ids_;
    CallMemory memory_[3];
    size_t depth_ = 0;  // number of calls around the present one
    uint32_t calls_inside_ = 0;
    bool wrote_after_error_ = false;
    const std::thread::id thread_ = std::this_thread::get_id();
};

}  // namespace random_arguments
