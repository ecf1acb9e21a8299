#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <regex>
#include <set>
#include <sstream>

#include <unistd.h>

#include "catch.h"
#include "hosted.h"

namespace random_calls_test {

using namespace hosted;

namespace {

std::string text_of(const std::string& path) {
    std::ifstream in(path);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Arguments for functions in C: some with a meaning, some without. Pointers are null or lead to
/// enough memory, as the headers demand; all numbers and texts may be anything.
class Arguments {
  public:
    explicit Arguments(uint32_t seed) : random_(seed) {
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

    uint32_t below(uint32_t count) { return uint32_t(random_()) % count; }

    template <class Result, class... Parameters>
    void call(Result (*function)(Parameters...)) {
        made_ = nullptr;
        function(argument(static_cast<Parameters*>(nullptr))...);
        if (made_ != nullptr) fettle_hosted_destroy(made_);
        for (auto& game : games_)
            if (fettle_hosted_steps(game, nullptr, nullptr, nullptr) == FETTLE_STALE)
                game = make();  // it was destroyed by the call
        for (auto& out : outs_)
            if (below(4) == 0) numbers_[below(uint32_t(numbers_.size()))] = out;
    }
    fettle_hosted* game(int i) const { return games_[i]; }

  private:
    /// With saved games, a store and kept edits, which the games share.
    fettle_hosted* make() {
        fettle_hosted* made = nullptr;
        fettle_hosted_def_init(&def_, sizeof def_);
        def_.saves = folder_.c_str();
        def_.store_file = store_.c_str();
        def_.tweaks_of = folder_.c_str();
        require(fettle_hosted_create(&def_, &made));
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
    fettle_hosted** argument(fettle_hosted***) { return below(9) == 0 ? nullptr : &made_; }

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
                for (uint32_t i = 0; i < made.count; ++i) elements_[depth][i] = value(depth + 1);
                made.as.list = below(20) == 0 ? nullptr : elements_[depth];
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
        for (auto& each : values_) each = value();
        return below(20) == 0 ? nullptr : values_;
    }
    const fettle_hosted_def* argument(const fettle_hosted_def**) {
        if (below(2) == 0) return nullptr;
        fettle_hosted_def_init(&def_, sizeof def_);
        def_.console = below(2) == 0;
        if (below(3) == 0) def_.call_seconds = argument(static_cast<double*>(nullptr));
        if (below(3) == 0) def_.lua_memory = random_() >> below(64);
        def_.assets = argument(static_cast<const char**>(nullptr));
        def_.name = argument(static_cast<const char**>(nullptr));
        // A relative path would be a folder of the tests.
        const char* const places[] = {"", folder_.c_str(), store_.c_str(), "/nonexistent/place",
                                      nullptr};
        def_.saves = places[below(5)];
        def_.store_file = places[below(5)];
        def_.tweaks_of = places[below(5)];
        if (below(5) == 0) def_.size = below(100);
        return &def_;
    }
    const fettle_class_def* argument(const fettle_class_def**) {
        constexpr const char** text = nullptr;
        fettle_class_def_init(&class_, sizeof class_);
        class_.name = argument(text);
        if (below(2) == 0) class_.base = argument(text);
        field_ = {argument(text), argument(text), nullptr, int32_t(below(10))};
        property_ = {};
        property_.name = argument(text);
        property_.type = int32_t(below(10));
        property_.default_value = value();
        property_.min = argument(static_cast<double*>(nullptr));
        property_.max = argument(static_cast<double*>(nullptr));
        method_ = {argument(text), nullptr, &field_, below(2), below(3), nullptr, this};
        if (below(9) != 0)
            method_.call = [](void* user, fettle_instance, const fettle_hosted_value*, uint32_t,
                              fettle_hosted_value* result) {
                nested(user);
                *result = static_cast<Arguments*>(user)->value();
                return fettle_code(static_cast<Arguments*>(user)->below(2));
            };
        event_ = {argument(text), argument(text), below(20) == 0 ? nullptr : &field_, below(2)};
        class_.properties = below(20) == 0 ? nullptr : &property_;
        class_.methods = &method_;
        class_.events = &event_;
        class_.property_count = below(2);
        class_.method_count = below(2);
        class_.event_count = below(2);
        return below(20) == 0 ? nullptr : &class_;
    }
    const fettle_hosted_input* argument(const fettle_hosted_input**) {
        static constexpr const char* names[] = {
            "grave", "a",      "enter",        "left", "f1",     "tab", "up",
            "x",     "escape", "left_control", "1",    "left_x", ""};
        fettle_hosted_input_init(&input_, sizeof input_);
        input_.kind = below(10) == 0 ? int32_t(random_()) : int32_t(below(15));
        input_.name = below(8) == 0 ? argument(static_cast<const char**>(nullptr))
                                    : names[below(uint32_t(std::size(names)))];
        input_.character = below(5) == 0 ? uint32_t(random_()) : 32 + below(90);
        input_.gamepad = int32_t(below(9)) - 2;
        input_.x = argument(static_cast<float*>(nullptr));
        input_.y = argument(static_cast<float*>(nullptr));
        input_.delta = argument(static_cast<float*>(nullptr));
        input_.control = below(4) == 0;
        input_.shift = below(4) == 0;
        return below(30) == 0 ? nullptr : &input_;
    }
    const double* argument(const double**) {
        for (double& each : map_) each = argument(static_cast<double*>(nullptr));
        return below(3) == 0 ? nullptr : map_;
    }
    const void* argument(const void**) {
        const void* bytes = scratch_;
        if (below(2) == 0) (void)fettle_hosted_snapshot(games_[0], &bytes, &saved_size_);
        return bytes;
    }

    // Callbacks: they call the library, too, with a pointer to the arguments.
    void* argument(void**) { return this; }
    static void nested(void* user) {
        auto& self = *static_cast<Arguments*>(user);
        for (fettle_hosted* game : self.games_) {
            fettle_hosted_destroy(game);
            (void)fettle_hosted_step(game);
            (void)fettle_hosted_run(game, "world.ball.bullet = true print('nested')", "nested");
            double number = 0;
            (void)fettle_property_get_number(game, self.numbers_[0], &number);
        }
    }
    fettle_print_callback argument(fettle_print_callback*) {  // and fettle_clipboard_write
        if (below(3) == 0) return nullptr;
        return [](void* user, const char*) { nested(user); };
    }
    fettle_problem_callback argument(fettle_problem_callback*) {
        if (below(3) == 0) return nullptr;
        return [](void* user, const fettle_hosted_problem*) { nested(user); };
    }
    fettle_function_callback argument(fettle_function_callback*) {
        return [](void* user, const fettle_hosted_value*, uint32_t, fettle_hosted_value* result) {
            nested(user);
            *result = static_cast<Arguments*>(user)->value();
            return fettle_code(static_cast<Arguments*>(user)->below(3));
        };
    }
    fettle_change_callback argument(fettle_change_callback*) {
        if (below(9) == 0) return nullptr;
        return [](void* user, const fettle_hosted_change*) { nested(user); };
    }
    fettle_existence_callback argument(fettle_existence_callback*) {
        return [](void* user, fettle_instance, const char*, const char*) { nested(user); };
    }
    fettle_event_callback argument(fettle_event_callback*) {
        return [](void* user, const fettle_hosted_occurrence*) { nested(user); };
    }
    fettle_clipboard_read argument(fettle_clipboard_read*) {
        return [](void*) { return "clipboard"; };
    }

    // Pointers to results.
    uint64_t* argument(uint64_t**) { return below(20) == 0 ? nullptr : &outs_[below(3)]; }
    template <class Out>
    requires(!std::is_const_v<Out>) Out* argument(Out**) {
        static_assert(sizeof(Out) * 8 <= sizeof scratch_);
        return below(20) == 0 ? nullptr : reinterpret_cast<Out*>(scratch_);
    }

    std::mt19937_64 random_;
    // Several processes may run this test.
    const std::string folder_ = (std::filesystem::temp_directory_path() /
                                 ("fettle_host_random_" + std::to_string(getpid())))
                                    .string();
    const std::string store_ = folder_ + "/store.json";
    std::array<fettle_hosted*, 2> games_{};
    fettle_hosted* stale_ = nullptr;
    fettle_hosted* made_ = nullptr;
    std::array<uint64_t, 12> numbers_{};  // ids of instances, properties and connections
    std::array<uint64_t, 3> outs_{};
    fettle_hosted_value values_[8] = {}, elements_[4][4] = {};
    fettle_hosted_def def_{};
    fettle_hosted_input input_{};
    fettle_class_def class_{};
    fettle_property_def property_{};
    fettle_method_def method_{};
    fettle_event_def event_{};
    fettle_parameter_def field_{};
    double map_[6] = {};
    size_t saved_size_ = 0;
    alignas(16) char scratch_[4096] = {};
};

struct Call {
    const char* name;
    void (*make)(Arguments&);
};

// clang-format off
#define CALL(function) {#function, [](Arguments& arguments) { arguments.call(&function); }}

constexpr Call every_call[] = {
    CALL(fettle_host_version), CALL(fettle_hosted_def_init), CALL(fettle_hosted_create),
    CALL(fettle_hosted_destroy), CALL(fettle_hosted_on_print), CALL(fettle_hosted_on_problem),
    CALL(fettle_hosted_load), CALL(fettle_hosted_reload), CALL(fettle_hosted_run),
    CALL(fettle_hosted_call), CALL(fettle_hosted_evaluate), CALL(fettle_hosted_add_function),
    CALL(fettle_hosted_frame), CALL(fettle_hosted_step), CALL(fettle_hosted_barrier),
    CALL(fettle_class_def_init), CALL(fettle_hosted_define),
    CALL(fettle_hosted_hash), CALL(fettle_hosted_find), CALL(fettle_hosted_is_alive),
    CALL(fettle_hosted_make), CALL(fettle_hosted_delete), CALL(fettle_hosted_move),
    CALL(fettle_hosted_parent), CALL(fettle_hosted_child), CALL(fettle_hosted_children),
    CALL(fettle_hosted_name), CALL(fettle_hosted_path), CALL(fettle_hosted_class_of),
    CALL(fettle_hosted_is_a), CALL(fettle_hosted_classes), CALL(fettle_hosted_members),
    CALL(fettle_hosted_call_method), CALL(fettle_hosted_get), CALL(fettle_hosted_set),
    CALL(fettle_hosted_reset), CALL(fettle_property_at), CALL(fettle_property_of),
    CALL(fettle_property_release), CALL(fettle_property_get), CALL(fettle_property_set),
    CALL(fettle_property_get_number), CALL(fettle_property_set_number),
    CALL(fettle_property_get_boolean), CALL(fettle_property_set_boolean),
    CALL(fettle_property_get_vec2), CALL(fettle_property_set_vec2),
    CALL(fettle_property_get_text), CALL(fettle_property_set_text),
    CALL(fettle_property_get_instance), CALL(fettle_property_set_instance),
    CALL(fettle_hosted_watch), CALL(fettle_property_watch), CALL(fettle_hosted_watch_made),
    CALL(fettle_hosted_watch_deleted), CALL(fettle_hosted_on), CALL(fettle_hosted_on_all),
    CALL(fettle_hosted_emit), CALL(fettle_hosted_disconnect), CALL(fettle_hosted_snapshot),
    CALL(fettle_hosted_save), CALL(fettle_hosted_load_save), CALL(fettle_hosted_delete_save),
    CALL(fettle_hosted_saves),
    CALL(fettle_hosted_rewind), CALL(fettle_hosted_go_to), CALL(fettle_hosted_steps),
    CALL(fettle_hosted_input_init), CALL(fettle_hosted_handle), CALL(fettle_console_draw),
    CALL(fettle_console_open), CALL(fettle_console_is_open), CALL(fettle_console_select),
    CALL(fettle_console_selected), CALL(fettle_console_print), CALL(fettle_console_set_view),
    CALL(fettle_console_set_clipboard),
    // A size must be that of the bytes.
    {"fettle_hosted_restore", [](Arguments& arguments) {
        const void* bytes = nullptr;
        size_t size = 0;
        if (fettle_hosted_snapshot(arguments.game(0), &bytes, &size) != FETTLE_DONE) return;
        std::string saved(static_cast<const char*>(bytes), size);
        if (arguments.below(2) == 0) saved[arguments.below(uint32_t(size))] ^= 4;
        if (arguments.below(3) == 0) saved.resize(arguments.below(uint32_t(size)));
        fettle_hosted_restore(arguments.game(int(arguments.below(2))), saved.data(), saved.size());
    }},
};
// clang-format on

std::set<std::string> functions_in_headers() {
    std::set<std::string> found;
    const std::string umbrella = text_of("bindings/host/include/fettle_host.h");
    const std::regex include("#include <(fettle/host/\\w+\\.h)>");
    const std::regex function("\n(?:fettle_code|bool|const char\\*) (fettle_\\w+)\\(");
    for (std::sregex_iterator it(umbrella.begin(), umbrella.end(), include), end; it != end; ++it) {
        const std::string text = text_of("bindings/host/include/" + (*it)[1].str());
        for (std::sregex_iterator each(text.begin(), text.end(), function), none; each != none;
             ++each)
            found.insert((*each)[1].str());
    }
    return found;
}

}  // namespace

TEST_CASE("every function of the headers is called at random") {
    std::set<std::string> named;
    for (const Call& call : every_call) named.insert(call.name);
    CHECK(named == functions_in_headers());
}

TEST_CASE("calls in any order with any arguments leave a game that works") {
    const char* const thorough = std::getenv("FETTLE_THOROUGH");
    const uint32_t seeds = thorough != nullptr ? 40 : 4, calls = 3000;
    for (uint32_t seed = 1; seed <= seeds; ++seed) {
        CAPTURE(seed);
        Arguments arguments(seed);
        for (uint32_t i = 0; i < calls; ++i)
            every_call[arguments.below(uint32_t(std::size(every_call)))].make(arguments);
        for (int i = 0; i < 2; ++i) {
            fettle_hosted* const game = arguments.game(i);
            (void)fettle_hosted_on_print(game, nullptr, nullptr);
            (void)fettle_hosted_on_problem(game, nullptr, nullptr);
            fettle_hosted_value result;
            CHECK(fettle_hosted_evaluate(game, "1 + 1", &result, nullptr) == FETTLE_DONE);
            INFO(fettle_last_error());
            CHECK((result.type == FETTLE_VALUE_INTEGER ? double(result.as.integer)
                                                       : result.as.number) == 2);
        }
    }
}

}  // namespace random_calls_test
