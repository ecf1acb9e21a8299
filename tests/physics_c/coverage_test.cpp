#include <fettle/physics/hooks.h>
#include <fettle/physics/host_access.h>
#include <fettle/physics/outlines.h>
#include <fettle/physics/physics.h>
#include <fettle_physics.h>

#include <map>

#include "catch.h"
#include "header_text.h"

namespace coverage_test {

// The interface in C has everything that the headers of the physics library declare.

using namespace fettle::physics;

namespace {

/// Without those whose classes only C++ needs: C has a pointer to a function with one for its data,
/// and an opaque pointer to a world.
const std::vector<std::string>& headers() {
    static const std::vector<std::string> all = [] {
        std::vector<std::string> files = header_text::files_of_physics();
        std::erase_if(files, [](const std::string& file) {
            return file == "function.h" || file == "owned.h";
        });
        return files;
    }();
    return all;
}

/// What stands for a method that has no function with its name, or for its overloads.
const std::map<std::string, std::vector<std::string>> other_names = {
    {"Body::index", {"fettle_slot"}},
    {"Shape::index", {"fettle_slot"}},
    {"Body::apply_force", {"fettle_body_apply_force", "fettle_body_apply_force_at"}},
    {"Body::apply_impulse", {"fettle_body_apply_impulse", "fettle_body_apply_impulse_at"}},
    {"World::restore", {"fettle_world_restore", "fettle_world_assign"}},
    {"World::create_joint", {"fettle_world_create_joint", "fettle_world_create_joint_like"}},
    {"World::query_overlap", {"fettle_world_query_overlap", "fettle_world_query_overlap_geometry"}},
    {"World::visit_overlap", {"fettle_world_visit_overlap", "fettle_world_visit_overlap_geometry"}},
    {"World::cast_shape", {"fettle_world_cast_shape", "fettle_world_cast_geometry"}},
    {"World::explode", {"fettle_world_explode", "fettle_world_explode_surfaces"}},
    {"World::is_valid",
     {"fettle_body_is_valid", "fettle_shape_is_valid", "fettle_joint_is_valid",
      "fettle_field_is_valid"}},
    {"HostAccess::state", {"fettle_world_state"}},
    {"HostAccess::states", {"fettle_world_columns"}},
    {"HostAccess::previous", {"fettle_world_previous"}},
    {"HostAccess::previous_poses", {"fettle_world_columns"}},
    {"HostAccess::mass", {"fettle_world_mass"}},
    {"HostAccess::velocity", {"fettle_world_velocity"}},
    {"HostAccess::set_velocity", {"fettle_world_set_velocity"}},
    {"HostAccess::write", {"fettle_world_write"}},
    {"HostAccess::write_velocity", {"fettle_world_write_velocity"}},
    {"HostAccess::body_generation", {"fettle_world_body_in"}},
    {"HostAccess::shape_generation", {"fettle_world_shape_in"}},
    {"HostAccess::body_slots", {"fettle_world_body_slots"}},
    {"HostAccess::shape_slots", {"fettle_world_shape_slots"}},
    {"HostAccess::on_refresh", {"fettle_world_on_refresh"}},
    {"HostAccess::refresh", {"fettle_world_refresh"}},
    {"Acting::Acting", {"fettle_owner_begin"}},
    {"Acting::~Acting", {"fettle_owner_end"}},
};

/// Methods without a function in C, and why.
const std::map<std::string, std::string> exceptions = {
    {"Body::id", "in C an object is its id"},
    {"Shape::id", "in C an object is its id"},
    {"Joint::id", "in C an object is its id"},
    {"Field::id", "in C an object is its id"},
    {"Body::world", "in C every call names the world"},
    {"Shape::world", "in C every call names the world"},
    {"Joint::world", "in C every call names the world"},
    {"Field::world", "in C every call names the world"},
    {"World::body", "makes a handle, which is an id in C"},
    {"World::shape", "makes a handle, which is an id in C"},
    {"World::joint", "makes a handle, which is an id in C"},
    {"World::field", "makes a handle, which is an id in C"},
    {"HostAccess::set_serial_callbacks",
     "a host in C has no callbacks of its own beside those that it sets"},
    {"HostAccess::joint_generation",
     "its bounds cannot be asked for; fettle_world_joints lists the ids"},
    {"Shape::segment_surface_overrides",
     "a list; fettle_shape_segment_surface_override gives each of its elements"},
    {"Owner::notify_unlocked", "the library calls it"},
    {"Mover::definition", "in C it is a structure of the caller, as is the state"},
    {"Mover::set_definition", "in C it is a structure of the caller"},
    {"Mover::state", "in C it is a structure of the caller"},
    {"Mover::set_state", "in C it is a structure of the caller"},
    {"Mover::position", "a member of the state in C"},
    {"Mover::set_position", "a member of the state in C"},
    {"Mover::on_ground", "a member of the state in C"},
    {"Mover::ground_normal", "a member of the state in C"},
    {"Mover::ground", "a member of the state in C"},
    {"Mover::climbing", "a member of the state in C"},
    {"Mover::set_climbing", "a member of the state in C"},
    {"Form::type", "in C a geometry is a structure of the caller"},
    {"Form::parts", "fettle_geometry_parts"},
    {"TaskScheduler::start", "an argument of fettle_world_set_scheduler"},
    {"TaskScheduler::finish", "an argument of fettle_world_set_scheduler"},
    {"DebugDraw::polygon", "a member of fettle_debug_draw"},
    {"DebugDraw::circle", "a member of fettle_debug_draw"},
    {"DebugDraw::segment", "a member of fettle_debug_draw"},
    {"DebugDraw::point", "a member of fettle_debug_draw"},
    {"DebugDraw::color_of", "a member of fettle_debug_draw"},
};

/// Structures without one in C, and why.
const std::map<std::string, std::string> other_structures = {
    {"BodyId", "fettle_id"},
    {"ShapeId", "fettle_id"},
    {"JointId", "fettle_id"},
    {"FieldId", "fettle_id"},
    {"ContactId", "two ids of shapes"},
    {"Position", "fettle_position"},
    {"Capacity", "the arguments of fettle_world_reserve"},
    {"Refresh", "the arguments of its functions"},
    {"Columns", "fettle_columns has pointers to what a host reads"},
    {"JointDef", "the definition of each type of joint has its members"},
    {"Polygon", "fettle_geometry has its points"},
    {"Concave", "fettle_geometry has its points"},
    {"FieldDef", "fettle_field_def has its members and those of its force"},
};

/// Functions outside of classes that have another name in C, or none, and why.
const std::map<std::string, std::string> other_functions = {
    {"convex_pieces", "fettle_geometry_parts of a concave geometry"},
    {"check", "each function that takes a definition checks it"},
    {"hash_of", "a number is its own hash"},
    {"version", "fettle_physics_version"},
};

struct Pair {
    const char* file;
    const char* structure;
    const char* in_c;
};
/// A structure of the library with what has its members in C.
const Pair pairs[] = {
    {"account.h", "ContactShare", "contact_share"},
    {"account.h", "JointShare", "joint_share"},
    {"account.h", "TurnAccount", "turn_account"},
    {"account.h", "VelocityAccount", "velocity_account"},
    {"debug_draw.h", "DebugDrawOptions", "debug_draw"},
    {"definitions.h", "WorldDef", "world_def"},
    {"definitions.h", "BodyDef", "body_def"},
    {"definitions.h", "ShapeDef", "shape_def"},
    {"definitions.h", "MouseJointDef", "mouse_joint_def"},
    {"joint_definitions.h", "DistanceJointDef", "distance_joint_def"},
    {"joint_definitions.h", "RevoluteJointDef", "revolute_joint_def"},
    {"joint_definitions.h", "PrismaticJointDef", "prismatic_joint_def"},
    {"joint_definitions.h", "WheelJointDef", "wheel_joint_def"},
    {"joint_definitions.h", "WeldJointDef", "weld_joint_def"},
    {"joint_definitions.h", "MotorJointDef", "motor_joint_def"},
    {"joint_definitions.h", "PulleyJointDef", "pulley_joint_def"},
    {"joint_definitions.h", "GearJointDef", "gear_joint_def"},
    {"joint_definitions.h", "GrooveJointDef", "groove_joint_def"},
    {"joint_definitions.h", "PinSlotJointDef", "pin_slot_joint_def"},
    {"joint_definitions.h", "RatchetJointDef", "ratchet_joint_def"},
    {"joint_definitions.h", "FilterJointDef", "filter_joint_def"},
    {"joint_definitions.h", "RotaryLimitJointDef", "rotary_limit_joint_def"},
    {"definitions.h", "Circle", "geometry"},
    {"definitions.h", "Box", "geometry"},
    {"definitions.h", "Segment", "geometry"},
    {"definitions.h", "Ellipse", "geometry"},
    {"definitions.h", "Chain", "geometry"},
    {"field.h", "WindField", "field_def"},
    {"field.h", "DragField", "field_def"},
    {"field.h", "BuoyancyField", "field_def"},
    {"field.h", "AttractorField", "field_def"},
    {"contact.h", "ContactPoint", "contact_point"},
    {"contact.h", "Contact", "contact"},
    {"callbacks.h", "ContactEdit", "contact_edit"},
    {"callbacks.h", "VelocityEdit", "velocity_edit"},
    {"callbacks.h", "PositionEdit", "position_edit"},
    {"definitions.h", "SegmentSurface", "segment_surface"},
    {"recording.h", "ReplayedStep", "replayed_step"},
    {"events.h", "ContactBeginEvent", "contact_event"},
    {"events.h", "ContactPersistEvent", "contact_event"},
    {"events.h", "ContactHitEvent", "contact_event"},
    {"events.h", "ContactEndEvent", "contact_end_event"},
    {"events.h", "SensorEvent", "sensor_event"},
    {"events.h", "JointBreakEvent", "joint_break_event"},
    {"events.h", "JointLoadEvent", "joint_load_event"},
    {"events.h", "Events", "events"},
    {"query.h", "QueryFilter", "query_filter"},
    {"query.h", "RayHit", "ray_hit"},
    {"query.h", "PointHit", "point_hit"},
    {"query.h", "Separation", "separation"},
    {"query.h", "ExplosionDef", "explosion_def"},
    {"geometry.h", "MassProperties", "mass_properties"},
    {"geometry.h", "SurfaceHit", "surface_hit"},
    {"geometry.h", "ContactManifold", "contact_manifold"},
    {"geometry.h", "Movement", "movement"},
    {"outlines.h", "JoinOptions", "join_options"},
    {"outlines.h", "GridLayout", "grid_layout"},
    {"mover.h", "MoverDef", "mover_def"},
    {"mover.h", "MoverState", "mover_state"},
    {"mover.h", "MoverPlane", "mover_plane"},
    {"mover.h", "Moved", "moved"},
    {"statistics.h", "StepStatistics", "statistics"},
    {"statistics.h", "MemoryShare", "memory_share"},
    {"types.h", "BodyState", "body_state"},
    {"types.h", "Pose", "pose"},
    {"types.h", "Aabb", "aabb"},
};

std::string snake_case(const std::string& name) {
    std::string snake;
    for (const char c : name) {
        if (c >= 'A' && c <= 'Z' && !snake.empty()) snake += '_';
        snake += char(std::tolower(c));
    }
    return snake;
}

/// "Body::mass" with the number of its overloads, for each public method that a header declares.
std::map<std::string, int> methods_in(const std::string& file) {
    std::map<std::string, int> found;
    const std::string text = header_text::of_physics(file);
    const std::regex method(
        "([\\w~]+)\\(([^()]|\\([^()]*\\))*\\)\\s*(const)?\\s*(noexcept)?\\s*(override)?\\s*(= "
        "0)?\\s*(;|\\{)");
    for (size_t at = text.find("\nclass "); at != std::string::npos;
         at = text.find("\nclass ", at + 1)) {
        const size_t end = text.find("\n};", at), begin = text.find("public:", at);
        if (begin > end || text.find(';', at) < begin) continue;
        const std::string head = text.substr(at + 7, begin - at);
        const std::string name = head.substr(0, head.find_first_of(" :{\n"));
        std::string body = text.substr(begin, end - begin);
        for (const char* part : {"\n  protected:", "\n  private:"})
            body = body.substr(0, body.find(part));
        body = std::regex_replace(body, std::regex("\\{[^{}]*\\}"), ";");  // what methods call
        for (std::sregex_iterator m(body.begin(), body.end(), method), none; m != none; ++m)
            ++found[name + "::" + (*m)[1].str()];
    }
    return found;
}

/// The text between the braces of a structure.
std::string members_of(const std::string& text, const std::string& begin) {
    const size_t at = text.find(begin + " {");
    if (at == std::string::npos) return {};
    return text.substr(at + begin.size() + 2, text.find("\n}", at) - at - begin.size() - 2);
}

std::set<std::string> names_in(const std::string& structure) {
    const std::string members = std::regex_replace(
        structure, std::regex("<[^<>]*>|static constexpr [^;]*;|friend [^;{}]*(;|\\{[^{}]*\\})"),
        "");
    std::set<std::string> names;
    const std::regex member("(\\w+)\\s*(=[^;]*)?;|(\\w+)\\s*(?=,)");
    for (std::sregex_iterator m(members.begin(), members.end(), member), none; m != none; ++m)
        names.insert((*m)[1].matched ? (*m)[1].str() : (*m)[3].str());
    return names;
}

std::vector<std::string> words_of(const std::string& text) {
    const std::regex word("[A-Za-z_]\\w*");
    std::vector<std::string> words;
    for (std::sregex_iterator it(text.begin(), text.end(), word), end; it != end; ++it)
        words.push_back(it->str());
    return words;
}

std::string upper_case(std::string text) {
    for (char& c : text) c = char(std::toupper(c));
    return text;
}

bool has_word(const std::string& text, const std::string& word) {
    return std::regex_search(text, std::regex("\\b" + word + "\\b"));
}

}  // namespace

TEST_CASE("every method of the library has a function in C") {
    const std::set<std::string> in_c = header_text::functions_in_c();
    size_t seen = 0;
    std::set<std::string> excepted;
    for (const std::string& file : headers()) {
        for (const auto& [method, overloads] : methods_in(file)) {
            const std::string type = method.substr(0, method.find(':')),
                              name = method.substr(method.rfind(':') + 1);
            // Constructors, comparison, and what the patterns take for a name.
            if (name == type || name == "~" + type || name == "operator" || name == "bool" ||
                name == "self" || name == "uint32_t" || name == "Acting" || name == "~Acting" ||
                name == "Form" || name.ends_with('_'))
                continue;
            INFO(method);
            if (exceptions.contains(method)) {
                excepted.insert(method);
                continue;
            }
            ++seen;
            if (const auto other = other_names.find(method); other != other_names.end()) {
                for (const std::string& function : other->second) CHECK(in_c.contains(function));
                continue;
            }
            // The overload for const, and one for each kind of id, need no function of their own.
            CHECK(overloads == 1);
            const bool forwarded = type == "MouseJoint" && name == "world";
            CHECK((forwarded || in_c.contains("fettle_" + snake_case(type) + "_" + name)));
        }
    }
    for (const auto& [method, reason] : exceptions) {
        INFO(method);
        CHECK(excepted.contains(method));
    }
    REQUIRE(seen > 330);
}

TEST_CASE("every structure of the library has one in C") {
    std::set<std::string> compared;
    for (const Pair& pair : pairs) compared.insert(pair.structure);
    const std::regex structure("\nstruct (\\w+)[^;{:]*\\{");
    size_t seen = 0;
    for (const std::string& file : headers()) {
        const std::string text = header_text::of_physics(file);
        for (std::sregex_iterator it(text.begin(), text.end(), structure), end; it != end; ++it) {
            const std::string name = (*it)[1].str();
            INFO(file << ": " << name);
            CHECK((compared.contains(name) || other_structures.contains(name)));
            ++seen;
        }
    }
    CHECK(seen == compared.size() + other_structures.size());
}

TEST_CASE("every function outside of classes has one in C") {
    const std::set<std::string> in_c = header_text::functions_in_c();
    const std::regex function(
        "\n(?:\\[\\[nodiscard\\]\\] )?(?!template|using|inline "
        "(?:Body|Shape|Joint|Field)::)[A-Za-z_][\\w:<>,&* ]*? "
        "(\\w+)\\(");
    std::set<std::string> seen;
    for (const std::string& file : headers()) {
        const std::string text = header_text::of_physics(file);
        for (std::sregex_iterator it(text.begin(), text.end(), function), end; it != end; ++it) {
            const std::string name = (*it)[1].str();
            INFO(file << ": " << name);
            seen.insert(name);
            CHECK((in_c.contains("fettle_" + name) || in_c.contains("fettle_geometry_" + name) ||
                   other_functions.contains(name)));
        }
    }
    CHECK(seen.size() > 18);
    for (const auto& [name, reason] : other_functions) {
        INFO(name);
        CHECK(seen.contains(name));
    }
}

TEST_CASE("every enumerator of the library has one in C with the same number") {
    const std::regex enumeration("enum class (\\w+)[^{;]*\\{([^}]*)\\}");
    size_t seen = 0;
    for (const std::string& file : headers()) {
        const std::string text = header_text::of_physics(file);
        for (std::sregex_iterator it(text.begin(), text.end(), enumeration), end; it != end; ++it) {
            const std::string name = (*it)[1].str();
            const std::string type = name == "Of" ? "refresh_of" : snake_case(name);
            const std::string values = members_of(header_text::in_c(), "enum fettle_" + type);
            std::vector<std::string> in_c;
            for (const std::string& word : words_of(values))
                if (word.starts_with("FETTLE_")) in_c.push_back(word);
            const std::vector<std::string> own = words_of((*it)[2].str());
            INFO(file << ": " << name);
            REQUIRE(own.size() == in_c.size());
            for (size_t i = 0; i < own.size(); ++i) {
                INFO(own[i]);
                // FETTLE_BODY_STATIC is `static_body`, since `static` is a word of C++.
                const std::string plain = own[i].substr(0, own[i].find("_body"));
                CHECK(in_c[i].ends_with("_" + upper_case(plain)));
                CHECK(std::regex_search(
                    values, std::regex("\\b" + in_c[i] + "\\s*=\\s*" + std::to_string(i) + "\\b")));
                ++seen;
            }
        }
    }
    CHECK(seen > 50);
}

TEST_CASE("every method of DebugDraw is a member in C") {
    const std::string in_c = members_of(header_text::in_c(), "typedef struct fettle_debug_draw");
    for (const auto& [method, overloads] : methods_in("debug_draw.h")) {
        const std::string name = method.substr(method.rfind(':') + 1);
        if (name == "DebugDraw" || name == "~DebugDraw" || name == "operator") continue;
        INFO(name);
        CHECK(in_c.find("(*" + name + ")") != std::string::npos);
    }
}

TEST_CASE("every other name of another function exists in C") {
    const std::set<std::string> in_c = header_text::functions_in_c();
    for (const auto& [method, functions] : other_names)
        for (const std::string& function : functions) {
            INFO(method);
            CHECK(in_c.contains(function));
        }
    for (const char* function :
         {"fettle_distance", "fettle_convex_hull", "fettle_describe", "fettle_simd_width",
          "fettle_world_create", "fettle_world_destroy", "fettle_world_clone",
          "fettle_world_assign", "fettle_world_draw", "fettle_join_lines", "fettle_set_log",
          "fettle_set_failure_function", "fettle_without_straight_points", "fettle_grid_outlines",
          "fettle_geometry_parts"})
        CHECK(in_c.contains(function));
}

TEST_CASE("every function on a geometry exists in C") {
    const std::set<std::string> in_c = header_text::functions_in_c();
    const std::string text = header_text::of_physics("geometry.h");
    const std::regex function("\n(?:\\[\\[nodiscard\\]\\] )?[\\w:<>]+ (\\w+)\\(const Form&");
    size_t seen = 0;
    for (std::sregex_iterator it(text.begin(), text.end(), function), end; it != end;
         ++it, ++seen) {
        INFO((*it)[1].str());
        CHECK(in_c.contains("fettle_geometry_" + (*it)[1].str()));
    }
    CHECK(seen == 7);
}

TEST_CASE("every member of a structure of the library is one in C") {
    const std::set<std::string> functions = header_text::functions_in_c();
    for (const Pair& pair : pairs) {
        const std::string own =
            members_of(header_text::of_physics(pair.file), std::string("struct ") + pair.structure);
        const std::string in_c =
            members_of(header_text::in_c(), std::string("typedef struct fettle_") + pair.in_c);
        REQUIRE(names_in(own).size() > 1);
        for (const std::string& member : names_in(own)) {
            INFO(pair.structure << "::" << member);
            const std::string list = std::string("fettle_world_account_") + member;
            CHECK((has_word(in_c, member) || functions.contains(list)));
        }
    }
}

TEST_CASE("enumerators in C are those of the library") {
    CHECK(FETTLE_BODY_DYNAMIC == int(BodyType::dynamic_body));
    CHECK(FETTLE_BODY_KINEMATIC == int(BodyType::kinematic_body));
    CHECK(FETTLE_SHAPE_SEGMENT == int(ShapeType::segment));
    CHECK(FETTLE_SHAPE_ELLIPSE == int(ShapeType::ellipse));
    CHECK(FETTLE_SHAPE_BORDER == int(ShapeType::border));
    CHECK(FETTLE_JOINT_WHEEL == int(JointType::wheel));
    CHECK(FETTLE_JOINT_PULLEY == int(JointType::pulley));
    CHECK(FETTLE_JOINT_RATCHET == int(JointType::ratchet));
    CHECK(FETTLE_JOINT_ROTARY_LIMIT == int(JointType::rotary_limit));
    CHECK(FETTLE_MIX_MAXIMUM == int(MixRule::maximum));
    CHECK(FETTLE_MIX_GEOMETRIC == int(MixRule::geometric));
    CHECK(FETTLE_SOLVER_SEQUENTIAL == int(Solver::sequential));
    CHECK(FETTLE_SOLVER_DIRECT == int(Solver::direct));
    CHECK(FETTLE_HULL_COLLINEAR == int(HullStatus::collinear));
    CHECK(FETTLE_HULL_NOT_FINITE == int(HullStatus::not_finite));
    CHECK(FETTLE_WINDING_COUNTER_CLOCKWISE == int(Winding::counter_clockwise));
    CHECK(FETTLE_REFRESH_SHAPE == int(Refresh::Of::shape));
    CHECK(FETTLE_NUMBER_ANGULAR_DAMPING == int(BodyNumber::angular_damping));
    CHECK(FETTLE_LOG_ERROR == int(LogLevel::error));
    CHECK(FETTLE_WRITTEN_REFUSED == int(Written::refused));
    CHECK(decltype(FieldDef::force)(AttractorField{}).index() == FETTLE_FIELD_ATTRACTOR);
}

TEST_CASE("the versions in C++ and in C are the same") {
    const auto number = [](int part) { return std::to_string(part); };
    CHECK(fettle_physics_version() == number(FETTLE_PHYSICS_VERSION_MAJOR) + "." +
                                          number(FETTLE_PHYSICS_VERSION_MINOR) + "." +
                                          number(FETTLE_PHYSICS_VERSION_PATCH));
}

TEST_CASE("every function in C has a comment before it") {
    const std::string umbrella = header_text::text_of("bindings/c/include/fettle_physics.h");
    const std::regex include("#include <(fettle/physics_c/\\w+\\.h)>");
    size_t seen = 0;
    for (std::sregex_iterator it(umbrella.begin(), umbrella.end(), include), end; it != end; ++it) {
        std::istringstream lines(header_text::text_of("bindings/c/include/" + (*it)[1].str()));
        // A comment holds for the group below it, to the next empty line.
        bool described = false;
        for (std::string line; std::getline(lines, line);) {
            if (line.empty()) described = false;
            if (line.find("*/") != std::string::npos) described = true;
            if (!line.starts_with("fettle_code ") && !line.starts_with("bool fettle_")) continue;
            INFO(line);
            CHECK(described);
            ++seen;
        }
    }
    REQUIRE(seen > 380);
}

}  // namespace coverage_test
