#pragma once

#include "random_arguments.h"

// Every function of fettle_host.h, to be called with random arguments.

namespace random_hosting {

struct Call {
    const char* name;
    void (*make)(Arguments&);
};

// clang-format off
#define CALL(function) {#function, [](Arguments& arguments) { arguments.call(&function); }}

inline constexpr Call every_call[] = {
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

#undef CALL

/// Makes one call.
inline const Call& any_call(Arguments& arguments) {
    const Call& call = every_call[arguments.below(uint32_t(std::size(every_call)))];
    call.make(arguments);
    return call;
}

inline void Arguments::inside(void* user) {
    auto& arguments = *static_cast<Arguments*>(user);
    if (arguments.depth_ + 1 == std::size(arguments.memory_)) return;
    if (arguments.calls_inside_ == 20 || arguments.below(2) != 0) return;
    ++arguments.depth_;
    ++arguments.calls_inside_;
    any_call(arguments);
    --arguments.depth_;
}

}  // namespace random_hosting
