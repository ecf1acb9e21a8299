#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include <unistd.h>

#include "hosted.h"
#include "numbers.h"

// Arguments for functions of fettle_host.h: valid ones and invalid ones.

namespace random_hosting {

using namespace hosted;

/// Arguments for functions in C: valid ones and invalid ones. Pointers are null or point to
/// enough memory, as the headers demand; all numbers and texts may be anything.
class Arguments {
  public:
    explicit Arguments(Numbers numbers) : random_(std::move(numbers)) {
        std::filesystem::create_directories(folder_);
        for (auto& game : games_) game = make();
        stale_ = make();
        fettle_hosted_destroy(stale_);
    }
    ~Arguments() {
        for (fettle_hosted* game : games_) fettle_hosted_destroy(game);
        std::filesystem::remove_all(folder_);
    }
    Arguments(const Arguments&) = delete;

    uint32_t below(uint32_t count) { return random_.below(count); }
    /// True if the input that chooses the arguments has ended.
    bool ended() const { return random_.ended(); }

    template <class Result, class... Parameters>
    void call(Result (*function)(Parameters...)) {
        Memory& of = memory();
        of.game = nullptr;
        function(argument(static_cast<Parameters*>(nullptr))...);
        if (depth_ == 0) calls_inside_ = 0;
        if (of.game != nullptr) fettle_hosted_destroy(of.game);
        for (auto& game : games_)
            if (fettle_hosted_steps(game, nullptr, nullptr, nullptr) == FETTLE_STALE)
                game = make();  // it was destroyed by the call
        for (auto& out : of.outs)
            if (below(4) == 0) numbers_[below(uint32_t(numbers_.size()))] = out;
    }
    fettle_hosted* game(int i) const { return games_[i]; }

  private:
    /// With saved games, a store and kept edits, which the games share.
    fettle_hosted* make() {
        fettle_hosted* made = nullptr;
        fettle_hosted_def_init(&memory().def, sizeof memory().def);
        memory().def.saves = folder_.c_str();
        memory().def.store_file = store_.c_str();
        memory().def.tweaks_of = folder_.c_str();
        require(fettle_hosted_create(&memory().def, &made));
        require(fettle_hosted_run(made,
                                  "world.ball = Body { Circle {}, position = vec(0, 5) } "
                                  "world.floor = Body { Box { width = 9 }, type = 'static' } "
                                  "function hear() end game.goal = world.ball game.list = { 1, 2 }",
                                  "start"));
        return made;
    }

    // Numbers.
    uint64_t argument(uint64_t*) {
        if (below(3) != 0) return numbers_[below(uint32_t(numbers_.size()))];
        return below(2) == 0 ? random_() : (uint64_t{1 + below(3)} << 32 | below(40));
    }
    int64_t argument(int64_t*) { return below(2) == 0 ? int64_t(random_()) : int64_t(below(50)); }
    uint32_t argument(uint32_t*) { return below(8); }
    double argument(double*) {
        const double odd[] = {std::nan(""), std::numeric_limits<double>::infinity(), -1, 1e300, 0};
        return below(3) == 0 ? odd[below(5)] : below(1000) * 0.01;
    }
    float argument(float*) { return float(argument(static_cast<double*>(nullptr))) * 100; }
    bool argument(bool*) { return below(2) == 0; }
    size_t size_for(size_t right) { return below(4) == 0 ? below(100) : right; }

    // Texts.
    const char* argument(const char**) {
        static constexpr const char* texts[] = {"world",
                                                "world.ball",
                                                "world.ball.position",
                                                "world.ball.position.y",
                                                "world.ball.mass",
                                                "goal",
                                                "list[1]",
                                                "list",
                                                "time.step",
                                                "console.font_size",
                                                "world.*.mass",
                                                "world.**",
                                                "Body",
                                                "Circle",
                                                "Wheel",
                                                "Tyre",
                                                "Object",
                                                "apply_impulse",
                                                "contact_begin",
                                                "ball",
                                                "position",
                                                "",
                                                "game",
                                                "..",
                                                "a b \xff\xfe",
                                                "[[\"",
                                                "hear",
                                                "world.floor:delete()",
                                                "1 +",
                                                "error('x')",
                                                "world.ball.mass = -1",
                                                "rewind(1)",
                                                "save_game('ball')",
                                                "load_game('ball')",
                                                "store.best = { 1, ball = 2 }",
                                                "keep('**')",
                                                "reapply_tweaks('world.*')",
                                                "world.ball = Body { Circle {} }",
                                                "/nonexistent/main.lua",
                                                "static",
                                                "%s%n"};
        return below(30) == 0 ? nullptr : texts[below(uint32_t(std::size(texts)))];
    }

    // Games.
    fettle_hosted* argument(fettle_hosted**) {
        const uint32_t choice = below(30);
        return choice == 0 ? nullptr : choice == 1 ? stale_ : games_[choice % 2];
    }
    const fettle_hosted* argument(const fettle_hosted**) {
        return argument(static_cast<fettle_hosted**>(nullptr));
    }
    fettle_hosted** argument(fettle_hosted***) { return below(9) == 0 ? nullptr : &memory().game; }

    // Input.
    fettle_hosted_value value(int depth = 0) {
        fettle_hosted_value made{};
        made.type = below(12) == 0 ? int32_t(random_()) : int32_t(below(9));
        switch (made.type) {
            case FETTLE_VALUE_TEXT:
                made.as.text = argument(static_cast<const char**>(nullptr));
                made.count = made.as.text == nullptr ? below(2) : uint32_t(strlen(made.as.text));
                break;
            case FETTLE_VALUE_INSTANCE:
                made.as.instance = argument(static_cast<uint64_t*>(nullptr));
                break;
            case FETTLE_VALUE_LIST:
                made.count = depth > 2 ? 0 : below(4);
                for (uint32_t i = 0; i < made.count; ++i)
                    memory().elements[depth][i] = value(depth + 1);
                made.as.list = below(20) == 0 ? nullptr : memory().elements[depth];
                break;
            case FETTLE_VALUE_INTEGER:
            case FETTLE_VALUE_BOOLEAN:
                made.as.integer = int64_t(random_());
                break;
            default:
                made.as.vec2[0] = argument(static_cast<double*>(nullptr));
                made.as.vec2[1] = argument(static_cast<double*>(nullptr));
        }
        return made;
    }
    const fettle_hosted_value* argument(const fettle_hosted_value**) {
        for (auto& each : memory().values) each = value();
        return below(20) == 0 ? nullptr : memory().values;
    }
    const fettle_hosted_def* argument(const fettle_hosted_def**) {
        Memory& of = memory();
        if (below(2) == 0) return nullptr;
        fettle_hosted_def_init(&of.def, sizeof of.def);
        of.def.console = below(2) == 0;
        if (below(3) == 0) of.def.call_seconds = argument(static_cast<double*>(nullptr));
        if (below(3) == 0) of.def.lua_memory = random_() >> below(64);
        of.def.assets = argument(static_cast<const char**>(nullptr));
        of.def.name = argument(static_cast<const char**>(nullptr));
        // A relative path would be a folder of the tests.
        const char* const places[] = {"", folder_.c_str(), store_.c_str(), "/nonexistent/place",
                                      nullptr};
        of.def.saves = places[below(5)];
        of.def.store_file = places[below(5)];
        of.def.tweaks_of = places[below(5)];
        if (below(5) == 0) of.def.size = below(100);
        return &of.def;
    }
    const fettle_class_def* argument(const fettle_class_def**) {
        Memory& of = memory();
        constexpr const char** text = nullptr;
        fettle_class_def_init(&of.a_class, sizeof of.a_class);
        of.a_class.name = argument(text);
        if (below(2) == 0) of.a_class.base = argument(text);
        of.field = {argument(text), argument(text), nullptr, int32_t(below(10))};
        of.property = {};
        of.property.name = argument(text);
        of.property.type = int32_t(below(10));
        of.property.default_value = value();
        of.property.min = argument(static_cast<double*>(nullptr));
        of.property.max = argument(static_cast<double*>(nullptr));
        of.method = {argument(text), nullptr, &of.field, below(2), below(3), nullptr, this};
        if (below(9) != 0)
            of.method.call = [](void* user, fettle_instance, const fettle_hosted_value* given,
                                uint32_t count, fettle_hosted_value* result) {
                nested(user);
                read(given, count);
                *result = static_cast<Arguments*>(user)->answer();
                return fettle_code(static_cast<Arguments*>(user)->below(2));
            };
        of.event = {argument(text), argument(text), below(20) == 0 ? nullptr : &of.field, below(2)};
        of.a_class.properties = below(20) == 0 ? nullptr : &of.property;
        of.a_class.methods = &of.method;
        of.a_class.events = &of.event;
        of.a_class.property_count = below(2);
        of.a_class.method_count = below(2);
        of.a_class.event_count = below(2);
        return below(20) == 0 ? nullptr : &of.a_class;
    }
    const fettle_hosted_input* argument(const fettle_hosted_input**) {
        Memory& of = memory();
        static constexpr const char* names[] = {
            "grave", "a",      "enter",        "left", "f1",     "tab", "up",
            "x",     "escape", "left_control", "1",    "left_x", ""};
        fettle_hosted_input_init(&of.input, sizeof of.input);
        of.input.kind = below(10) == 0 ? int32_t(random_()) : int32_t(below(15));
        of.input.name = below(8) == 0 ? argument(static_cast<const char**>(nullptr))
                                      : names[below(uint32_t(std::size(names)))];
        of.input.character = below(5) == 0 ? uint32_t(random_()) : 32 + below(90);
        of.input.gamepad = int32_t(below(9)) - 2;
        of.input.x = argument(static_cast<float*>(nullptr));
        of.input.y = argument(static_cast<float*>(nullptr));
        of.input.delta = argument(static_cast<float*>(nullptr));
        of.input.control = below(4) == 0;
        of.input.shift = below(4) == 0;
        return below(30) == 0 ? nullptr : &of.input;
    }
    const double* argument(const double**) {
        for (double& each : memory().map) each = argument(static_cast<double*>(nullptr));
        return below(3) == 0 ? nullptr : memory().map;
    }
    const void* argument(const void**) {
        const void* bytes = memory().scratch;
        if (below(2) == 0) (void)fettle_hosted_snapshot(games_[0], &bytes, &memory().saved_size);
        return bytes;
    }

    // Callbacks: they call the library, too, with a pointer to the arguments.
    void* argument(void**) { return this; }
    static void nested(void* user) {
        auto& self = *static_cast<Arguments*>(user);
        inside(user);
        if (self.depth_ > 0) return;
        for (fettle_hosted* game : self.games_) {
            fettle_hosted_destroy(game);
            (void)fettle_hosted_step(game);
            (void)fettle_hosted_run(game, "world.ball.bullet = true print('nested')", "nested");
            double number = 0;
            (void)fettle_property_get_number(game, self.numbers_[0], &number);
        }
    }
    /// Makes a call inside a callback of another call; `user` points to the arguments.
    static void inside(void* user);
    /// A callback answers with a value in memory that no call uses.
    fettle_hosted_value answer() {
        ++depth_;
        const fettle_hosted_value made = value();
        --depth_;
        return made;
    }
    /// The arguments of a callback must be valid until it returns.
    static void read(const char* text) {
        if (text != nullptr && strlen(text) > 100'000'000) std::abort();
    }
    static void read(const fettle_hosted_value& value) {
        if (value.type == FETTLE_VALUE_TEXT && strlen(value.as.text) > value.count) std::abort();
        if (value.type != FETTLE_VALUE_LIST) return;
        for (uint32_t i = 0; i < value.count; ++i) read(value.as.list[i]);
    }
    static void read(const fettle_hosted_value* values, uint32_t count) {
        for (uint32_t i = 0; i < count; ++i) read(values[i]);
    }
    fettle_print_callback argument(fettle_print_callback*) {  // and fettle_clipboard_write
        if (below(3) == 0) return nullptr;
        return [](void* user, const char* text) {
            nested(user);
            read(text);
        };
    }
    fettle_problem_callback argument(fettle_problem_callback*) {
        if (below(3) == 0) return nullptr;
        return [](void* user, const fettle_hosted_problem* problem) {
            nested(user);
            for (const char* text : {problem->message, problem->file, problem->source_line,
                                     problem->traceback, problem->context})
                read(text);
        };
    }
    fettle_function_callback argument(fettle_function_callback*) {
        return [](void* user, const fettle_hosted_value* given, uint32_t count,
                  fettle_hosted_value* result) {
            nested(user);
            read(given, count);
            *result = static_cast<Arguments*>(user)->answer();
            return fettle_code(static_cast<Arguments*>(user)->below(3));
        };
    }
    fettle_change_callback argument(fettle_change_callback*) {
        if (below(9) == 0) return nullptr;
        return [](void* user, const fettle_hosted_change* change) {
            nested(user);
            read(change->property);
            read(change->cause);
            read(change->old_value);
            read(change->new_value);
        };
    }
    fettle_existence_callback argument(fettle_existence_callback*) {
        return [](void* user, fettle_instance, const char* class_name, const char* path) {
            nested(user);
            read(class_name);
            read(path);
        };
    }
    fettle_event_callback argument(fettle_event_callback*) {
        return [](void* user, const fettle_hosted_occurrence* occurrence) {
            nested(user);
            read(occurrence->event);
            for (uint32_t i = 0; i < occurrence->count; ++i) {
                read(occurrence->fields[i]);
                read(occurrence->values[i]);
            }
        };
    }
    fettle_clipboard_read argument(fettle_clipboard_read*) {
        return [](void* user) {
            nested(user);
            return "clipboard";
        };
    }

    // Pointers to results.
    uint64_t* argument(uint64_t**) { return below(20) == 0 ? nullptr : &memory().outs[below(3)]; }
    template <class Out>
    requires(!std::is_const_v<Out>) Out* argument(Out**) {
        static_assert(sizeof(Out) * 8 <= sizeof(Memory::scratch));
        return below(20) == 0 ? nullptr : reinterpret_cast<Out*>(memory().scratch);
    }

    Numbers random_;
    // Several processes may run this test.
    const std::string folder_ = (std::filesystem::temp_directory_path() /
                                 ("fettle_host_random_" + std::to_string(getpid())))
                                    .string();
    const std::string store_ = folder_ + "/store.json";
    std::array<fettle_hosted*, 2> games_{};
    fettle_hosted* stale_ = nullptr;
    std::array<uint64_t, 12> numbers_{};  // ids of instances, properties and connections
    /// The memory that the pointers of a call point to. A call inside a callback must not write to
    /// that of the outer call.
    struct Memory {
        fettle_hosted* game = nullptr;  // made by the call
        std::array<uint64_t, 3> outs{};
        fettle_hosted_value values[8] = {}, elements[4][4] = {};
        fettle_hosted_def def{};
        fettle_hosted_input input{};
        fettle_class_def a_class{};
        fettle_property_def property{};
        fettle_method_def method{};
        fettle_event_def event{};
        fettle_parameter_def field{};
        double map[6] = {};
        size_t saved_size = 0;
        alignas(16) char scratch[4096] = {};
    };
    Memory& memory() { return memory_[depth_]; }

    std::array<Memory, 4> memory_{};
    size_t depth_ = 0;  // number of calls around the present one
    uint32_t calls_inside_ = 0;
};

}  // namespace random_hosting
