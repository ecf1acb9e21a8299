#include <algorithm>
#include <cstring>

#include "catch.h"
#include "header_text.h"
#include "random_arguments.h"
#include "thorough.h"

namespace random_calls_test {

using random_arguments::Arguments;

namespace {

struct Call {
    const char* name;
    void (*make)(Arguments&);
};

// clang-format off
#define CALL(function) {#function, [](Arguments& arguments) { arguments.call(&function); }}

constexpr Call every_call[] = {
    CALL(fettle_simd_width), CALL(fettle_slot), CALL(fettle_convex_hull),
    CALL(fettle_describe), CALL(fettle_body_is_valid), CALL(fettle_body_destroy),
    CALL(fettle_body_type), CALL(fettle_body_set_type), CALL(fettle_body_position),
    CALL(fettle_body_set_position), CALL(fettle_body_angle), CALL(fettle_body_set_angle),
    CALL(fettle_body_set_pose), CALL(fettle_body_velocity), CALL(fettle_body_set_velocity),
    CALL(fettle_body_angular_velocity), CALL(fettle_body_set_angular_velocity),
    CALL(fettle_body_set_velocity_function), CALL(fettle_body_set_position_function),
    CALL(fettle_shape_segment_count), CALL(fettle_shape_segment_surface),
    CALL(fettle_shape_set_segment_surface), CALL(fettle_shape_segment_surface_override),
    CALL(fettle_shape_set_segment_surfaces), CALL(fettle_world_start_recording),
    CALL(fettle_world_stop_recording), CALL(fettle_world_is_recorded),
    CALL(fettle_replay_create), CALL(fettle_replay_steps), CALL(fettle_replay_step),
    CALL(fettle_replay_world), CALL(fettle_set_log), CALL(fettle_set_failure_function),
    CALL(fettle_body_set_target), CALL(fettle_world_after_step), CALL(fettle_world_reserve),
    CALL(fettle_world_moved_bodies),
    CALL(fettle_body_enabled), CALL(fettle_world_set_scheduler), CALL(fettle_body_set_enabled), CALL(fettle_body_name),
    CALL(fettle_body_set_name), CALL(fettle_body_max_speed), CALL(fettle_body_set_max_speed),
    CALL(fettle_body_sleep_speed), CALL(fettle_body_set_sleep_speed),
    CALL(fettle_body_sleep_speed_override), CALL(fettle_shape_contact_events),
    CALL(fettle_shape_set_contact_events), CALL(fettle_shape_sensor_events),
    CALL(fettle_shape_set_sensor_events), CALL(fettle_shape_before_solve),
    CALL(fettle_shape_set_before_solve), CALL(fettle_shape_material),
    CALL(fettle_shape_set_material), CALL(fettle_world_is_touching),
    CALL(fettle_world_contacts_of), CALL(fettle_world_ignore_until_separated),
    CALL(fettle_world_contact_data), CALL(fettle_world_set_contact_data),
    CALL(fettle_world_parallel_callbacks), CALL(fettle_world_set_parallel_callbacks),
    CALL(fettle_body_force), CALL(fettle_body_set_force), CALL(fettle_body_torque),
    CALL(fettle_body_set_torque), CALL(fettle_body_apply_force),
    CALL(fettle_body_apply_force_at), CALL(fettle_body_apply_impulse),
    CALL(fettle_body_apply_impulse_at), CALL(fettle_body_apply_torque),
    CALL(fettle_body_apply_angular_impulse), CALL(fettle_body_applied_force),
    CALL(fettle_body_applied_torque), CALL(fettle_body_gravity_scale),
    CALL(fettle_body_set_gravity_scale), CALL(fettle_body_linear_damping),
    CALL(fettle_body_set_linear_damping), CALL(fettle_body_angular_damping),
    CALL(fettle_body_set_angular_damping), CALL(fettle_body_awake),
    CALL(fettle_body_set_awake), CALL(fettle_body_can_sleep), CALL(fettle_body_set_can_sleep),
    CALL(fettle_body_bullet), CALL(fettle_body_set_bullet), CALL(fettle_body_locked_x),
    CALL(fettle_body_set_locked_x), CALL(fettle_body_locked_y), CALL(fettle_body_set_locked_y),
    CALL(fettle_body_locked_rotation), CALL(fettle_body_set_locked_rotation),
    CALL(fettle_body_mass), CALL(fettle_body_set_mass), CALL(fettle_body_mass_override),
    CALL(fettle_body_inertia), CALL(fettle_body_set_inertia),
    CALL(fettle_body_inertia_override), CALL(fettle_body_center), CALL(fettle_body_set_center),
    CALL(fettle_body_center_override), CALL(fettle_body_world_center), CALL(fettle_body_area),
    CALL(fettle_body_aabb), CALL(fettle_body_rebuilds), CALL(fettle_body_previous_pose),
    CALL(fettle_body_interpolated), CALL(fettle_body_world_point),
    CALL(fettle_body_local_point), CALL(fettle_body_world_vector),
    CALL(fettle_body_local_vector), CALL(fettle_body_velocity_at),
    CALL(fettle_body_kinetic_energy), CALL(fettle_body_add), CALL(fettle_body_shape_count),
    CALL(fettle_body_shapes), CALL(fettle_body_joints), CALL(fettle_body_is_touching),
    CALL(fettle_body_contacts), CALL(fettle_body_user_data), CALL(fettle_body_set_user_data),
    CALL(fettle_world_set_filter), CALL(fettle_world_set_mixing),
    CALL(fettle_world_set_before_solve), CALL(fettle_world_on_refresh),
    CALL(fettle_world_refresh), CALL(fettle_world_locked), CALL(fettle_owner_create),
    CALL(fettle_owner_on_unlocked), CALL(fettle_owner_begin), CALL(fettle_owner_end),
    CALL(fettle_owner_acts), CALL(fettle_owner_advice), CALL(fettle_world_set_owner),
    CALL(fettle_world_columns), CALL(fettle_world_contacts), CALL(fettle_world_state),
    CALL(fettle_world_previous), CALL(fettle_world_mass), CALL(fettle_world_velocity),
    CALL(fettle_world_body_in), CALL(fettle_world_shape_in), CALL(fettle_world_body_slots),
    CALL(fettle_world_shape_slots), CALL(fettle_world_write),
    CALL(fettle_world_write_velocity), CALL(fettle_world_set_velocity),
    CALL(fettle_worlds_step), CALL(fettle_worlds_read_states),
    CALL(fettle_worlds_apply_forces), CALL(fettle_motor_joint_linear_velocity),
    CALL(fettle_motor_joint_set_linear_velocity), CALL(fettle_motor_joint_angular_velocity),
    CALL(fettle_motor_joint_set_angular_velocity), CALL(fettle_motor_joint_max_force),
    CALL(fettle_motor_joint_set_max_force), CALL(fettle_motor_joint_max_torque),
    CALL(fettle_motor_joint_set_max_torque), CALL(fettle_motor_joint_linear_offset),
    CALL(fettle_motor_joint_set_linear_offset), CALL(fettle_motor_joint_angular_offset),
    CALL(fettle_motor_joint_set_angular_offset), CALL(fettle_motor_joint_hertz),
    CALL(fettle_motor_joint_set_hertz), CALL(fettle_motor_joint_damping_ratio),
    CALL(fettle_motor_joint_set_damping_ratio), CALL(fettle_pulley_joint_ground_a),
    CALL(fettle_pulley_joint_set_ground_a), CALL(fettle_pulley_joint_ground_b),
    CALL(fettle_pulley_joint_set_ground_b), CALL(fettle_pulley_joint_ratio),
    CALL(fettle_pulley_joint_set_ratio), CALL(fettle_pulley_joint_length),
    CALL(fettle_pulley_joint_set_length), CALL(fettle_pulley_joint_length_now),
    CALL(fettle_pulley_joint_length_a), CALL(fettle_pulley_joint_length_b),
    CALL(fettle_pulley_joint_tension), CALL(fettle_gear_joint_ratio),
    CALL(fettle_gear_joint_set_ratio), CALL(fettle_gear_joint_phase),
    CALL(fettle_gear_joint_set_phase), CALL(fettle_gear_joint_phase_now),
    CALL(fettle_ratchet_joint_angle), CALL(fettle_ratchet_joint_reference_angle),
    CALL(fettle_ratchet_joint_set_reference_angle), CALL(fettle_ratchet_joint_tooth),
    CALL(fettle_ratchet_joint_set_tooth), CALL(fettle_ratchet_joint_backwards),
    CALL(fettle_ratchet_joint_set_backwards), CALL(fettle_ratchet_joint_caught_angle),
    CALL(fettle_world_def_init), CALL(fettle_body_def_init), CALL(fettle_shape_def_init),
    CALL(fettle_distance_joint_def_init), CALL(fettle_revolute_joint_def_init), CALL(fettle_prismatic_joint_def_init), CALL(fettle_wheel_joint_def_init), CALL(fettle_weld_joint_def_init), CALL(fettle_motor_joint_def_init), CALL(fettle_pulley_joint_def_init), CALL(fettle_gear_joint_def_init), CALL(fettle_groove_joint_def_init), CALL(fettle_pin_slot_joint_def_init), CALL(fettle_ratchet_joint_def_init), CALL(fettle_filter_joint_def_init), CALL(fettle_rotary_limit_joint_def_init), CALL(fettle_mouse_joint_def_init), CALL(fettle_geometry_init),
    CALL(fettle_field_def_init), CALL(fettle_debug_draw_init), CALL(fettle_world_draw),
    CALL(fettle_world_events), CALL(fettle_field_is_valid), CALL(fettle_field_destroy),
    CALL(fettle_field_definition), CALL(fettle_field_set), CALL(fettle_mouse_joint_body),
    CALL(fettle_mouse_joint_set_body), CALL(fettle_mouse_joint_anchor),
    CALL(fettle_mouse_joint_set_anchor), CALL(fettle_mouse_joint_target),
    CALL(fettle_mouse_joint_set_target), CALL(fettle_mouse_joint_hertz),
    CALL(fettle_mouse_joint_set_hertz), CALL(fettle_mouse_joint_damping_ratio),
    CALL(fettle_mouse_joint_set_damping_ratio), CALL(fettle_mouse_joint_max_force),
    CALL(fettle_mouse_joint_set_max_force), CALL(fettle_distance_joint_length),
    CALL(fettle_distance_joint_set_length), CALL(fettle_distance_joint_min_length),
    CALL(fettle_distance_joint_set_min_length), CALL(fettle_distance_joint_max_length),
    CALL(fettle_distance_joint_set_max_length), CALL(fettle_distance_joint_hertz),
    CALL(fettle_distance_joint_set_hertz), CALL(fettle_distance_joint_damping_ratio),
    CALL(fettle_distance_joint_set_damping_ratio), CALL(fettle_distance_joint_distance),
    CALL(fettle_revolute_joint_angle), CALL(fettle_revolute_joint_reference_angle),
    CALL(fettle_revolute_joint_set_reference_angle), CALL(fettle_revolute_joint_lower_angle),
    CALL(fettle_revolute_joint_set_lower_angle), CALL(fettle_revolute_joint_upper_angle),
    CALL(fettle_revolute_joint_set_upper_angle), CALL(fettle_revolute_joint_motor_speed),
    CALL(fettle_revolute_joint_set_motor_speed), CALL(fettle_revolute_joint_max_motor_torque),
    CALL(fettle_revolute_joint_set_max_motor_torque), CALL(fettle_revolute_joint_hertz),
    CALL(fettle_revolute_joint_set_hertz), CALL(fettle_revolute_joint_damping_ratio),
    CALL(fettle_revolute_joint_set_damping_ratio), CALL(fettle_revolute_joint_target_angle),
    CALL(fettle_revolute_joint_set_target_angle), CALL(fettle_revolute_joint_motor_torque),
    CALL(fettle_weld_joint_angle), CALL(fettle_weld_joint_reference_angle),
    CALL(fettle_weld_joint_set_reference_angle), CALL(fettle_weld_joint_hertz),
    CALL(fettle_weld_joint_set_hertz), CALL(fettle_weld_joint_damping_ratio),
    CALL(fettle_weld_joint_set_damping_ratio), CALL(fettle_weld_joint_angular_hertz),
    CALL(fettle_weld_joint_set_angular_hertz), CALL(fettle_weld_joint_angular_damping_ratio),
    CALL(fettle_weld_joint_set_angular_damping_ratio), CALL(fettle_joint_is_valid),
    CALL(fettle_joint_destroy), CALL(fettle_joint_type), CALL(fettle_joint_body_a),
    CALL(fettle_joint_set_body_a), CALL(fettle_joint_body_b), CALL(fettle_joint_set_body_b),
    CALL(fettle_joint_connect), CALL(fettle_joint_disconnect), CALL(fettle_joint_dormant),
    CALL(fettle_joint_anchor_a), CALL(fettle_joint_set_anchor_a), CALL(fettle_joint_anchor_b),
    CALL(fettle_joint_set_anchor_b), CALL(fettle_joint_world_anchor_a),
    CALL(fettle_joint_world_anchor_b), CALL(fettle_joint_enabled),
    CALL(fettle_joint_set_enabled), CALL(fettle_joint_collide), CALL(fettle_joint_set_collide),
    CALL(fettle_joint_break_force), CALL(fettle_joint_set_break_force),
    CALL(fettle_joint_break_torque), CALL(fettle_joint_set_break_torque),
    CALL(fettle_joint_broken), CALL(fettle_joint_set_broken), CALL(fettle_joint_force),
    CALL(fettle_joint_torque), CALL(fettle_joint_user_data), CALL(fettle_joint_set_user_data),
    CALL(fettle_query_filter_init), CALL(fettle_world_query_point),
    CALL(fettle_world_visit_point), CALL(fettle_world_query_aabb),
    CALL(fettle_world_visit_aabb), CALL(fettle_world_query_overlap),
    CALL(fettle_world_visit_overlap), CALL(fettle_world_query_overlap_geometry),
    CALL(fettle_world_visit_overlap_geometry), CALL(fettle_world_cast_ray),
    CALL(fettle_world_cast_ray_all), CALL(fettle_world_visit_ray),
    CALL(fettle_world_cast_shape), CALL(fettle_world_cast_geometry),
    CALL(fettle_world_closest), CALL(fettle_distance), CALL(fettle_world_explode),
    CALL(fettle_shape_is_valid), CALL(fettle_shape_destroy), CALL(fettle_shape_type),
    CALL(fettle_shape_body), CALL(fettle_shape_attach), CALL(fettle_shape_detach),
    CALL(fettle_shape_geometry), CALL(fettle_shape_set_geometry), CALL(fettle_shape_radius),
    CALL(fettle_shape_set_radius), CALL(fettle_shape_radius_x),
    CALL(fettle_shape_set_radius_x), CALL(fettle_shape_radius_y),
    CALL(fettle_shape_set_radius_y), CALL(fettle_shape_center), CALL(fettle_shape_set_center),
    CALL(fettle_shape_width), CALL(fettle_shape_set_width), CALL(fettle_shape_height),
    CALL(fettle_shape_set_height), CALL(fettle_shape_angle), CALL(fettle_shape_set_angle),
    CALL(fettle_shape_rounding), CALL(fettle_shape_set_rounding), CALL(fettle_shape_from),
    CALL(fettle_shape_set_from), CALL(fettle_shape_to), CALL(fettle_shape_set_to),
    CALL(fettle_shape_vertices), CALL(fettle_shape_set_vertices),
    CALL(fettle_shape_try_set_vertices), CALL(fettle_shape_add_vertex),
    CALL(fettle_shape_closed), CALL(fettle_shape_set_closed), CALL(fettle_shape_pieces),
    CALL(fettle_shape_density), CALL(fettle_shape_set_density), CALL(fettle_shape_friction),
    CALL(fettle_shape_set_friction), CALL(fettle_shape_restitution),
    CALL(fettle_shape_set_restitution), CALL(fettle_shape_rolling_resistance),
    CALL(fettle_shape_set_rolling_resistance), CALL(fettle_shape_surface_speed),
    CALL(fettle_shape_set_surface_speed), CALL(fettle_shape_sensor),
    CALL(fettle_shape_set_sensor), CALL(fettle_shape_hit_events),
    CALL(fettle_shape_set_hit_events), CALL(fettle_shape_category),
    CALL(fettle_shape_set_category), CALL(fettle_shape_mask), CALL(fettle_shape_set_mask),
    CALL(fettle_shape_group), CALL(fettle_shape_set_group), CALL(fettle_shape_area),
    CALL(fettle_shape_mass), CALL(fettle_shape_aabb), CALL(fettle_shape_world_vertices),
    CALL(fettle_shape_contains), CALL(fettle_shape_world_center),
    CALL(fettle_shape_is_touching), CALL(fettle_shape_rebuilds), CALL(fettle_shape_user_data),
    CALL(fettle_shape_set_user_data), CALL(fettle_prismatic_joint_axis),
    CALL(fettle_prismatic_joint_set_axis), CALL(fettle_prismatic_joint_translation),
    CALL(fettle_prismatic_joint_lower_translation),
    CALL(fettle_prismatic_joint_set_lower_translation),
    CALL(fettle_prismatic_joint_upper_translation),
    CALL(fettle_prismatic_joint_set_upper_translation),
    CALL(fettle_prismatic_joint_motor_speed), CALL(fettle_prismatic_joint_set_motor_speed),
    CALL(fettle_prismatic_joint_max_motor_force),
    CALL(fettle_prismatic_joint_set_max_motor_force), CALL(fettle_prismatic_joint_motor_force),
    CALL(fettle_prismatic_joint_hertz), CALL(fettle_prismatic_joint_set_hertz),
    CALL(fettle_prismatic_joint_damping_ratio), CALL(fettle_prismatic_joint_set_damping_ratio),
    CALL(fettle_prismatic_joint_target_translation),
    CALL(fettle_prismatic_joint_set_target_translation), CALL(fettle_prismatic_joint_angle),
    CALL(fettle_prismatic_joint_reference_angle),
    CALL(fettle_prismatic_joint_set_reference_angle), CALL(fettle_pin_slot_joint_axis),
    CALL(fettle_pin_slot_joint_set_axis), CALL(fettle_pin_slot_joint_translation),
    CALL(fettle_pin_slot_joint_lower_translation),
    CALL(fettle_pin_slot_joint_set_lower_translation),
    CALL(fettle_pin_slot_joint_upper_translation),
    CALL(fettle_pin_slot_joint_set_upper_translation), CALL(fettle_pin_slot_joint_motor_speed),
    CALL(fettle_pin_slot_joint_set_motor_speed), CALL(fettle_pin_slot_joint_max_motor_force),
    CALL(fettle_pin_slot_joint_set_max_motor_force), CALL(fettle_pin_slot_joint_motor_force),
    CALL(fettle_pin_slot_joint_hertz), CALL(fettle_pin_slot_joint_set_hertz),
    CALL(fettle_pin_slot_joint_damping_ratio), CALL(fettle_pin_slot_joint_set_damping_ratio),
    CALL(fettle_pin_slot_joint_target_translation),
    CALL(fettle_pin_slot_joint_set_target_translation), CALL(fettle_groove_joint_end),
    CALL(fettle_groove_joint_set_end), CALL(fettle_groove_joint_translation),
    CALL(fettle_wheel_joint_axis), CALL(fettle_wheel_joint_set_axis),
    CALL(fettle_wheel_joint_translation), CALL(fettle_wheel_joint_hertz),
    CALL(fettle_wheel_joint_set_hertz), CALL(fettle_wheel_joint_damping_ratio),
    CALL(fettle_wheel_joint_set_damping_ratio), CALL(fettle_wheel_joint_lower_translation),
    CALL(fettle_wheel_joint_set_lower_translation), CALL(fettle_wheel_joint_upper_translation),
    CALL(fettle_wheel_joint_set_upper_translation), CALL(fettle_wheel_joint_motor_speed),
    CALL(fettle_wheel_joint_set_motor_speed), CALL(fettle_wheel_joint_max_motor_torque),
    CALL(fettle_wheel_joint_set_max_motor_torque), CALL(fettle_wheel_joint_motor_torque),
    CALL(fettle_world_create), CALL(fettle_world_destroy), CALL(fettle_world_step),
    CALL(fettle_world_wake_all), CALL(fettle_world_clear), CALL(fettle_world_create_body),
    CALL(fettle_world_create_shape), CALL(fettle_world_create_field),
    CALL(fettle_world_create_joint), CALL(fettle_world_create_joint_like),
    CALL(fettle_world_create_mouse_joint), CALL(fettle_world_create_distance_joint),
    CALL(fettle_world_create_revolute_joint), CALL(fettle_world_create_prismatic_joint),
    CALL(fettle_world_create_wheel_joint), CALL(fettle_world_create_weld_joint),
    CALL(fettle_world_create_motor_joint), CALL(fettle_world_create_pulley_joint),
    CALL(fettle_world_create_gear_joint), CALL(fettle_world_create_groove_joint),
    CALL(fettle_world_create_pin_slot_joint), CALL(fettle_world_create_ratchet_joint),
    CALL(fettle_world_bodies), CALL(fettle_world_shapes), CALL(fettle_world_joints),
    CALL(fettle_world_fields), CALL(fettle_world_body_count), CALL(fettle_world_shape_count),
    CALL(fettle_world_joint_count), CALL(fettle_world_clone), CALL(fettle_world_assign),
    CALL(fettle_world_take), CALL(fettle_world_save), CALL(fettle_world_restore),
    CALL(fettle_world_hash), CALL(fettle_world_statistics), CALL(fettle_world_memory),
    CALL(fettle_world_validate), CALL(fettle_world_gravity), CALL(fettle_world_set_gravity),
    CALL(fettle_world_substeps), CALL(fettle_world_last_substeps), CALL(fettle_world_set_substeps), CALL(fettle_world_bounds),
    CALL(fettle_world_set_bounds), CALL(fettle_world_bounds_friction),
    CALL(fettle_world_set_bounds_friction), CALL(fettle_world_bounds_restitution),
    CALL(fettle_world_set_bounds_restitution), CALL(fettle_world_sleeping),
    CALL(fettle_world_set_sleeping), CALL(fettle_world_continuous),
    CALL(fettle_world_set_continuous), CALL(fettle_world_restitution_threshold),
    CALL(fettle_world_set_restitution_threshold), CALL(fettle_world_hit_threshold),
    CALL(fettle_world_set_hit_threshold), CALL(fettle_world_sleep_speed),
    CALL(fettle_world_set_sleep_speed), CALL(fettle_world_sleep_delay),
    CALL(fettle_world_set_sleep_delay), CALL(fettle_world_contact_hertz),
    CALL(fettle_world_set_contact_hertz), CALL(fettle_world_contact_damping),
    CALL(fettle_world_set_contact_damping), CALL(fettle_world_push_speed),
    CALL(fettle_world_set_push_speed), CALL(fettle_world_solver),
    CALL(fettle_world_set_solver), CALL(fettle_world_friction_mix),
    CALL(fettle_world_set_friction_mix), CALL(fettle_world_restitution_mix),
    CALL(fettle_world_set_restitution_mix), CALL(fettle_world_persist_events),
    CALL(fettle_world_set_persist_events), CALL(fettle_world_threads),
    CALL(fettle_world_set_threads), CALL(fettle_world_limit_simd_width),
    CALL(fettle_join_options_init), CALL(fettle_grid_layout_init),
    CALL(fettle_geometry_mass_properties), CALL(fettle_geometry_bounding_box),
    CALL(fettle_geometry_contains), CALL(fettle_geometry_cast_ray),
    CALL(fettle_geometry_distance), CALL(fettle_geometry_contact_manifolds),
    CALL(fettle_geometry_time_of_impact), CALL(fettle_geometry_parts), CALL(fettle_join_lines),
    CALL(fettle_without_straight_points), CALL(fettle_grid_outlines),
    CALL(fettle_joint_report_force), CALL(fettle_joint_set_report_force),
    CALL(fettle_joint_report_torque), CALL(fettle_joint_set_report_torque),
    CALL(fettle_joint_constraint_hertz), CALL(fettle_joint_set_constraint_hertz),
    CALL(fettle_joint_constraint_damping_ratio), CALL(fettle_joint_set_constraint_damping_ratio),
    CALL(fettle_joint_separation), CALL(fettle_joint_angular_separation),
    CALL(fettle_distance_joint_lower_spring_force),
    CALL(fettle_distance_joint_set_lower_spring_force),
    CALL(fettle_distance_joint_upper_spring_force),
    CALL(fettle_distance_joint_set_upper_spring_force), CALL(fettle_distance_joint_motor_speed),
    CALL(fettle_distance_joint_set_motor_speed), CALL(fettle_distance_joint_max_motor_force),
    CALL(fettle_distance_joint_set_max_motor_force), CALL(fettle_distance_joint_motor_force),
    CALL(fettle_rotary_limit_joint_angle), CALL(fettle_rotary_limit_joint_reference_angle),
    CALL(fettle_rotary_limit_joint_set_reference_angle),
    CALL(fettle_rotary_limit_joint_lower_angle), CALL(fettle_rotary_limit_joint_set_lower_angle),
    CALL(fettle_rotary_limit_joint_upper_angle), CALL(fettle_rotary_limit_joint_set_upper_angle),
    CALL(fettle_explosion_def_init), CALL(fettle_world_explode_surfaces),
    CALL(fettle_world_create_filter_joint), CALL(fettle_world_create_rotary_limit_joint),
    CALL(fettle_mover_def_init), CALL(fettle_mover_state_init), CALL(fettle_mover_move),
    CALL(fettle_mover_drop), CALL(fettle_mover_fits), CALL(fettle_mover_set_height),
    CALL(fettle_mover_planes), CALL(fettle_solve_planes), CALL(fettle_clip_velocity),
    CALL(fettle_world_keep_account), CALL(fettle_world_account),
    CALL(fettle_world_account_contacts), CALL(fettle_world_account_joints),
};
// clang-format on

#undef CALL

}  // namespace

TEST_CASE("the list of calls has every function of the headers") {
    std::set<std::string> listed = {
        // Without arguments, or the pointer must not be used afterwards.
        "fettle_last_error", "fettle_physics_version", "fettle_owner_destroy",
        "fettle_replay_destroy"};
    for (const Call& call : every_call) listed.insert(call.name);
    REQUIRE(listed == header_text::functions_in_c());
}

TEST_CASE("calls in any order with any arguments leave consistent worlds") {
    std::vector<Call> calls(std::begin(every_call), std::end(every_call));
    // Worlds stay full enough for calls to have objects.
    for (const Call& call : every_call)
        if (std::strcmp(call.name, "fettle_world_create_body") == 0 ||
            std::strcmp(call.name, "fettle_body_add") == 0 ||
            std::strcmp(call.name, "fettle_world_step") == 0)
            calls.insert(calls.end(), 30, call);
    uint32_t most_touching = 0;
    const uint32_t seeds = thorough() ? 300 : 30;
    for (uint32_t seed = 1; seed <= seeds; ++seed) {
        Arguments arguments(seed);
        for (int i = 0; i < 3000; ++i) {
            const Call& call = calls[arguments.below(uint32_t(calls.size()))];
            call.make(arguments);
            if (i % 100 != 0) continue;
            for (int k = 0; k < 3; ++k) {
                const char* fault = nullptr;
                REQUIRE(fettle_world_validate(arguments.world(k), &fault) == FETTLE_DONE);
                INFO("seed " << seed << ", call " << i << ", the last one " << call.name << ": "
                             << (fault != nullptr ? fault : ""));
                REQUIRE(fault == nullptr);
                fettle_statistics statistics;
                REQUIRE(fettle_world_statistics(arguments.world(k), &statistics) == FETTLE_DONE);
                most_touching = std::max(most_touching, statistics.touching);
            }
        }
    }
    REQUIRE(most_touching > 3);  // the calls had worlds with something in them
}

}  // namespace random_calls_test
