#include <fettle/property/spelling.h>

#include <other_languages/synonyms.h>
#include <text/words.h>

namespace fettle::script {

namespace {

struct Synonym {
    std::string_view words;  // separated by blanks, in lower case without underscores
    std::vector<std::string_view> meant;
};

const std::vector<Synonym>& properties() {
    static const std::vector<Synonym> table = {
        {"pos location place getposition transform",
         {"position", "center", "world", "offset", "corner"}},
        {"offset", {"center"}},
        // of the view, the mouse, widgets and maps
        {"position", {"center", "world", "offset", "corner"}},
        {"x y", {"position = vec(x, y)", "center = vec(x, y)", "offset = vec(x, y)", "world"}},
        {"rot rotation rotationdegrees globalrotation orientation heading direction", {"angle"}},
        {"vel linearvelocity", {"velocity"}},
        {"speed", {"velocity"}},
        {"vx vy dx dy velx vely", {"velocity = vec(x, y)"}},
        {"omega spin rotationspeed angularspeed angularvel", {"angular_velocity"}},
        {"r rad", {"radius"}},
        {"d diameter", {"radius"}},
        {"w", {"width", "size"}},
        {"h", {"height", "size"}},
        {"width height", {"size = vec(width, height)"}},
        {"size dimensions extents", {"width", "radius"}},
        {"print printf", {"text"}},
        {"bounce bounciness elasticity", {"restitution"}},
        {"static isstatic anchored fixed immovable bodytype", {"type = \"static\""}},
        {"kinematic iskinematic", {"type = \"kinematic\""}},
        {"dynamic isdynamic", {"type = \"dynamic\""}},
        {"bodya nodea", {"body_a"}},
        {"bodyb nodeb connectedbody", {"body_b"}},
        {"body collider otherbody othercollider", {"other"}},
        {"a pointa p1 point1 startpoint vertex1", {"from", "body_a"}},
        {"b pointb p2 point2 endpoint vertex2", {"to", "body_b"}},
        {"localanchora anchor1 pivota", {"anchor_a"}},
        {"localanchorb anchor2 pivotb", {"anchor_b"}},
        {"usemotor enablemotor motorenabled", {"max_motor_torque", "max_motor_force"}},
        {"uselimits enablelimit limitenabled angularlimitenabled",
         {"lower_angle = -1, upper_angle = 1", "lower_translation = -1, upper_translation = 1"}},
        {"springstiffness stiffness frequency frequencyhz", {"hertz", "frequency"}},
        {"freq hz tone note", {"frequency", "pitch"}},
        {"hertz", {"frequency"}},
        {"pitch", {"frequency"}},
        {"waveform oscillator type", {"wave"}},
        {"fixedrotation freezerotation lockrotation", {"locked_rotation"}},
        {"trigger istrigger issensor", {"sensor"}},
        {"fill fillcolor tint rgb rgba background backgroundcolor", {"color", "tint"}},
        {"color colour modulate", {"color", "tint"}},
        {"alpha opacity transparency", {"opacity", "color", "tint"}},
        {"hidden show shown", {"visible"}},
        {"enabled isenabled interactable", {"disabled"}},
        {"zindex zorder drawlayer", {"z"}},
        {"img texture picture", {"image"}},
        {"src source path file filename", {"image", "file", "map"}},
        {"fps framerate", {"frames_per_second"}},
        {"cols hframes", {"columns"}},
        {"vframes", {"rows"}},
        {"pivot anchor anchorpoint", {"origin", "anchor", "anchor_a"}},
        {"rx", {"radius_x"}},
        {"ry", {"radius_y"}},
        {"hx halfwidth", {"width"}},
        {"hy halfheight", {"height"}},
        {"thickness linewidth strokewidth", {"width"}},
        {"stroke strokecolor outlinecolor", {"border", "outline"}},
        {"flip fliph mirror mirrored", {"flip_x"}},
        {"flipv", {"flip_y"}},
        {"loop isloop", {"closed", "loops"}},
        {"pingpong yoyo", {"alternate"}},
        {"maxparticles maxcount", {"limit"}},
        {"emissionrate spawnrate", {"rate"}},
        {"looping repeat", {"loop"}},
        {"gain loudness", {"volume"}},
        {"life lifespan duration seconds", {"lifetime", "seconds", "decay"}},
        {"target", {"follow"}},
        {"caption label title content", {"text"}},
        {"fontsize textsize", {"font_size", "size"}},
        {"checked ison", {"value"}},
        {"from minimum minvalue lowest", {"min"}},
        {"to range maximum maxvalue highest", {"max"}},
        {"options choices entries", {"items"}},
        {"gap separation", {"spacing"}},
        {"margin", {"padding"}},
        {"down isdown pressed", {"held", "left"}},
        {"cancel disconnect unsubscribe", {"stop"}},
        {"weight", {"mass", "density"}},
        {"mass", {"density"}},
        {"damping drag lineardrag", {"linear_damping"}},
        {"angulardrag rotationdamping", {"angular_damping"}},
        {"gravityfactor", {"gravity_scale"}},
        {"points verts corners", {"vertices"}},
        {"vertices", {"points"}},
        {"layer collisionlayer", {"category"}},
        {"collisionmask", {"mask"}},
        {"g", {"gravity"}},
        {"destroy remove kill free queuefree despawn", {"delete"}},
        {"addforce applycentralforce", {"apply_force"}},
        {"addimpulse applylinearimpulse applycentralimpulse", {"apply_impulse"}},
        {"addtorque", {"apply_torque"}},
        {"magnitude mag norm", {"length"}},
        {"distance distanceto restlength", {"distance", "length"}},
        {"limit limitlength clamp clamped trimmed truncated", {"limited"}},
        {"delta deltatime elapsed", {"dt", "now"}},
        {"addchild append insert spawn", {"add"}},
        {"child getchild getchildren getchildcount", {"children"}},
        {"findchild findfirstchild getnode", {"find"}},
        {"addeventlistener connect", {"on"}},
        {"raytest raycastclosest raycastany", {"raycast"}},
        {"return", {"enter"}},
        {"ctrl control lctrl", {"left_control"}},
        {"rctrl", {"right_control"}},
        {"shift lshift", {"left_shift"}},
        {"rshift", {"right_shift"}},
        {"alt lalt", {"left_alt"}},
        {"ralt", {"right_alt"}},
        {"esc", {"escape"}},
        {"del", {"delete"}},
        {"ins", {"insert"}},
        {"spacebar", {"space"}},
        {"pageup pgup", {"page_up"}},
        {"pagedown pgdn", {"page_down"}},
        {"leftarrow arrowleft", {"left"}},
        {"rightarrow arrowright", {"right"}},
        {"uparrow arrowup", {"up"}},
        {"downarrow arrowdown", {"down"}},
        {"-", {"minus"}},
        {"= +", {"equal"}},
        {"kp0 num0 keypad0", {"numpad_0"}},
        {"kp1 num1 keypad1", {"numpad_1"}},
        {"kp2 num2 keypad2", {"numpad_2"}},
        {"kp3 num3 keypad3", {"numpad_3"}},
        {"kp4 num4 keypad4", {"numpad_4"}},
        {"kp5 num5 keypad5", {"numpad_5"}},
        {"kp6 num6 keypad6", {"numpad_6"}},
        {"kp7 num7 keypad7", {"numpad_7"}},
        {"kp8 num8 keypad8", {"numpad_8"}},
        {"kp9 num9 keypad9", {"numpad_9"}},
        {"lmb mouse mouse1 mouse.1 mouseleft leftmouse click", {"mouse.left"}},
        {"rmb mouse2 mouse.2 mouseright rightmouse", {"mouse.right"}},
        {"mmb mouse3 mouse.3 mousemiddle middlemouse", {"mouse.middle"}},
    };
    return table;
}

const std::vector<Synonym>& callbacks() {
    static const std::vector<Synonym> table = {
        {"load init initialize setup create awake begin main ready", {"start", "ready"}},
        {"update tick process", {"update", "step"}},  // instances have only a step
        {"physicsprocess fixedupdate think", {"step", "update"}},
        {"render paint redraw", {"draw"}},
        {"key keydown keypress keypressed input", {"key_pressed"}},
        {"keyup keyrelease keyreleased", {"key_released"}},
        {"click clicked mousedown mouseclick mousepressed touch touchpressed",
         {"mouse_pressed", "pressed"}},
        {"onclick onpress onpressed activated buttondown", {"pressed"}},
        {"pressed justpressed down", {"press"}},
        {"released justreleased up", {"release"}},
        {"change onchange valuechanged textchanged", {"changed"}},
        {"onfinish onend ended done completed oncomplete", {"finished"}},
        {"mouseup mousereleased", {"mouse_released"}},
        {"mousemove mousemoved", {"mouse_moved"}},
        {"wheelmoved mousewheel scroll", {"wheel"}},
        {"joystickpressed gamepaddown", {"gamepad_pressed"}},
        {"resize", {"resized"}},
        {"exit close quitting", {"closing"}},
        {"contact collide collided collision collisionenter collisionenter2d begincontact touched "
         "contactstart contactstarted contactbegan collisionstart collisionstarted "
         "bodyentered hit",
         {"contact_begin"}},
        {"collisionexit collisionexit2d endcontact contactstop contactstopped contactended "
         "collisionstop collisionended bodyexited",
         {"contact_end"}},
        {"trigger triggerenter triggerenter2d areaentered sensorenter areaenter overlap",
         {"sensor_begin"}},
        {"triggerexit triggerexit2d areaexited sensorexit sensorleave areaexit", {"sensor_end"}},
        {"destroy destroyed remove removed exittree", {"deleted"}},
    };
    return table;
}

// The form of "OnCollisionEnter2D" and "_physics_process" in the tables.
std::string plain(std::string_view name) {
    std::string text;
    for (const char c : name)
        if (c != '_') text += static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
    return text;
}

std::vector<std::string_view> look_up(const std::vector<Synonym>& table, std::string_view word) {
    for (const Synonym& synonym : table)
        if (holds_word(synonym.words, word)) return synonym.meant;
    return {};
}

}  // namespace

std::vector<std::string_view> property_synonyms(std::string_view name) {
    return look_up(properties(), plain(name));
}

std::string hint_of(std::string_view meant) {
    return " (did you mean " + std::string(meant) + "?)";
}

std::string hint_at(const std::vector<std::string_view>& meant, std::string_view name,
                    const std::vector<std::string>& known) {
    // "Position" means position, before the synonyms of that word.
    for (const std::string& each : known)
        if (plain(each) == plain(name)) return hint_of("\"" + each + "\"");
    for (const std::string_view way : meant)
        if (const auto written = way.substr(0, way.find(' ')); among(known, written))
            return hint_of("\"" + std::string(written) + "\"");
    return property::suggestion(name, known);
}

std::string without_get_or_set(std::string_view name) {
    for (const std::string_view verb : {"get", "set", "Get", "Set"}) {
        if (!name.starts_with(verb) || name.size() <= verb.size()) continue;
        std::string_view rest = name.substr(verb.size());
        if (rest.front() == '_')
            rest.remove_prefix(1);
        else if (rest.front() < 'A' || rest.front() > 'Z')
            continue;
        return snake_case(rest);
    }
    return {};
}

std::string snake_case(std::string_view name) {
    std::string snake;
    for (const char c : name) {
        const bool capital = c >= 'A' && c <= 'Z';
        if (capital && !snake.empty()) snake += '_';
        snake += static_cast<char>(capital ? c + 32 : c);
    }
    return snake;
}

std::vector<std::string_view> callback_synonyms(std::string_view name) {
    const std::string word = plain(name);
    std::vector<std::string_view> meant = look_up(callbacks(), word);
    if (meant.empty() && word.starts_with("on"))
        meant = look_up(callbacks(), std::string_view(word).substr(2));
    return meant;
}

}  // namespace fettle::script
