#include <images/sheet.h>

#include <algorithm>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace fettle::visuals {
namespace {

using nlohmann::json;

constexpr std::size_t most_frames = 100'000;

Frame read_frame(const json& from) {
    const json& cut = from.at("frame");
    Frame frame;
    frame.area = {cut.at("x").get<double>(), cut.at("y").get<double>(), cut.at("w").get<double>(),
                  cut.at("h").get<double>()};
    frame.size = {frame.area.width, frame.area.height};
    if (const auto whole = from.find("sourceSize"); whole != from.end())
        frame.size = {whole->at("w").get<double>(), whole->at("h").get<double>()};
    if (const auto place = from.find("spriteSourceSize"); place != from.end())
        frame.offset = {place->at("x").get<double>(), place->at("y").get<double>()};
    frame.seconds = std::clamp(from.value("duration", 0.0) / 1000, 0.0, 1e6);
    return frame;
}

Animation read_tag(const json& from, std::size_t count) {
    Animation made;
    made.name = from.at("name").get<std::string>();
    const auto first = from.at("from").get<std::size_t>(), last = from.at("to").get<std::size_t>();
    if (first > last || last >= count)
        throw std::runtime_error("the tag \"" + made.name + "\" has frames that do not exist");
    const std::string direction = from.value("direction", "forward");
    for (std::size_t i = first; i <= last; ++i) made.frames.push_back(i);
    if (direction.starts_with("pingpong"))
        for (std::size_t i = last; i > first + 1; --i) made.frames.push_back(i - 1);
    if (direction == "reverse" || direction == "pingpong_reverse")
        std::reverse(made.frames.begin(), made.frames.end());
    return made;
}

Export read(const json& from) {
    Export read;
    read.image = from.at("meta").at("image").get<std::string>();
    // "Hash" exports have an object with the names of the frames, "array" exports a list.
    for (const json& frame : from.at("frames")) {
        if (read.frames.size() >= most_frames) throw std::runtime_error("it has too many frames");
        read.frames.push_back(read_frame(frame));
    }
    if (read.frames.empty()) throw std::runtime_error("it has no frames");
    if (const auto tags = from.at("meta").find("frameTags"); tags != from.at("meta").end())
        for (const json& tag : *tags) read.animations.push_back(read_tag(tag, read.frames.size()));
    return read;
}

}  // namespace

const Animation* Sheet::animation(std::string_view name) const {
    const auto at = std::find_if(animations.begin(), animations.end(),
                                 [&](const Animation& each) { return each.name == name; });
    return at == animations.end() ? nullptr : &*at;
}

Export read_export(std::string_view text) {
    try {
        return read(json::parse(text));
    } catch (const json::exception& error) {
        throw std::runtime_error(std::string("is no JSON export of Aseprite: ") + error.what());
    }
}

}  // namespace fettle::visuals
