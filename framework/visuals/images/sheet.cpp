#include <images/sheet.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace fettle::visuals {
namespace {

using nlohmann::json;

constexpr std::size_t most_frames = 100'000;
constexpr std::size_t most_played = 1'000'000;  // frames of all tags together

/// A value of the file, and where it is: "frames.2.frame.x".
struct Part {
    const json& node;
    std::string path{};

    [[noreturn]] void fail(const std::string& expected) const {
        throw std::runtime_error(
            "is not a JSON export of Aseprite: " + (path.empty() ? "" : path + ": ") + "expected " +
            expected + ", got " + shown());
    }
    /// The beginning of its text.
    std::string shown() const {
        if (node.is_object()) return "an object";
        if (node.is_array()) return "a list";
        constexpr std::size_t longest = 60;
        std::string text = node.dump(-1, ' ', true, json::error_handler_t::replace);
        if (text.size() > longest) text = text.substr(0, longest) + "…";
        return text;
    }
    Part child(const std::string& key, const json& value) const {
        return {value, path.empty() ? key : path + "." + key};
    }
    /// Empty if it has no such member.
    std::optional<Part> find(const char* key) const {
        if (!node.is_object()) fail("an object");
        const auto found = node.find(key);
        if (found == node.end()) return std::nullopt;
        return child(key, *found);
    }
    Part at(const char* key) const {
        if (const std::optional<Part> found = find(key)) return *found;
        fail("an object with \"" + std::string(key) + "\"");
    }
    double number() const {
        if (!node.is_number()) fail("a number");
        return node.get<double>();
    }
    std::string text() const {
        if (!node.is_string()) fail("a text");
        return node.get<std::string>();
    }
    std::size_t index(std::size_t count) const {
        if (node.is_number_unsigned() && node.get<std::uint64_t>() < count)
            return node.get<std::size_t>();
        fail("a frame from 0 to " + std::to_string(count - 1));
    }
    /// The elements of a list, or the members of an object.
    template <class Visit>
    void each(Visit visit) const {
        if (!node.is_structured()) fail("a list");
        std::size_t number = 0;
        for (const json& element : node) visit(child(std::to_string(number++), element));
    }
};

Frame read_frame(const Part& from) {
    const Part cut = from.at("frame");
    Frame frame;
    frame.area = {cut.at("x").number(), cut.at("y").number(), cut.at("w").number(),
                  cut.at("h").number()};
    frame.size = {frame.area.width, frame.area.height};
    if (const auto whole = from.find("sourceSize"))
        frame.size = {whole->at("w").number(), whole->at("h").number()};
    if (const auto place = from.find("spriteSourceSize"))
        frame.offset = {place->at("x").number(), place->at("y").number()};
    if (const auto duration = from.find("duration"))
        frame.seconds = std::clamp(duration->number() / 1000, 0.0, 1e6);
    return frame;
}

/// `played`: the number of frames of the tags before it.
Animation read_tag(const Part& from, std::size_t count, std::size_t played) {
    Animation made;
    made.name = from.at("name").text();
    const std::size_t first = from.at("from").index(count), last = from.at("to").index(count);
    if (first > last) from.at("to").fail("a frame that is not before \"from\"");
    if (played + 2 * (last - first + 1) > most_played)
        throw std::runtime_error("its tags have more than " + std::to_string(most_played) +
                                 " frames");
    const auto order = from.find("direction");
    const std::string direction = order ? order->text() : "forward";
    for (std::size_t i = first; i <= last; ++i) made.frames.push_back(i);
    if (direction.starts_with("pingpong"))
        for (std::size_t i = last; i > first + 1; --i) made.frames.push_back(i - 1);
    if (direction == "reverse" || direction == "pingpong_reverse")
        std::reverse(made.frames.begin(), made.frames.end());
    return made;
}

/// The names of the frames in the order of the file. "Hash" exports have an object with the names
/// of the frames, "array" exports a list. The library sorts an object by its names, and "10" is
/// before "2" then. Also refuses a value inside too many others, which takes the library much
/// memory. It is no callback of `parse`, which looks at all members of a list at the end of each.
class FrameNames : public nlohmann::json_sax<json> {
  public:
    std::vector<std::string> all{};

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(json::number_integer_t) override { return true; }
    bool number_unsigned(json::number_unsigned_t) override { return true; }
    bool number_float(json::number_float_t, const std::string&) override { return true; }
    bool string(std::string&) override { return true; }
    bool binary(json::binary_t&) override { return true; }
    bool start_object(std::size_t) override { return enter(); }
    bool end_object() override { return leave(); }
    bool start_array(std::size_t) override { return enter(); }
    bool end_array() override { return leave(); }
    bool key(std::string& name) override {
        if (depth_ == 1) member_ = name;
        if (depth_ == 2 && member_ == "frames") all.push_back(name);
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const json::exception&) override {
        return false;
    }

  private:
    bool enter() {
        constexpr int deepest = 64;
        if (++depth_ > deepest)
            throw std::runtime_error("is not a JSON export of Aseprite: nested deeper than " +
                                     std::to_string(deepest) + " levels");
        return true;
    }
    bool leave() {
        --depth_;
        return true;
    }

    int depth_ = 0;
    std::string member_{};  // of the document, the one that is being read
};

Export read(const Part& from) {
    Export read;
    const Part meta = from.at("meta");
    read.image = meta.at("image").text();
    from.at("frames").each([&](const Part& frame) {
        if (read.frames.size() >= most_frames)
            throw std::runtime_error("it has more than " + std::to_string(most_frames) + " frames");
        read.frames.push_back(read_frame(frame));
    });
    if (read.frames.empty()) throw std::runtime_error("it has no frames");
    std::size_t played = 0;
    if (const auto tags = meta.find("frameTags"))
        tags->each([&](const Part& tag) {
            read.animations.push_back(read_tag(tag, read.frames.size(), played));
            played += read.animations.back().frames.size();
        });
    return read;
}

}  // namespace

FrameGrid FrameGrid::divided(const property::Picture& picture, std::int64_t columns,
                             std::int64_t rows, double margin, double spacing) {
    const auto share = [&](double pixels, std::int64_t count) {
        const auto frames = static_cast<double>(count);
        return std::max(0.0, (pixels - 2 * margin - (frames - 1) * spacing) / frames);
    };
    return {columns,
            rows,
            margin,
            spacing,
            {share(picture.width(), columns), share(picture.height(), rows)}};
}

FrameGrid FrameGrid::filled(const property::Picture& picture, const property::Vec2& size,
                            double margin, double spacing) {
    const auto fit = [&](double pixels, double frame) {
        const double all = (pixels - 2 * margin + spacing) / (frame + spacing);
        return static_cast<std::int64_t>(std::clamp(all, 1.0, 10'000.0));
    };
    return {fit(picture.width(), size.x), fit(picture.height(), size.y), margin, spacing, size};
}

property::PictureFrame FrameGrid::at(std::size_t index) const {
    const auto across = static_cast<std::size_t>(columns);
    const std::size_t column = index % across, row = index / across;
    return {.area = {margin + static_cast<double>(column) * (size.x + spacing),
                     margin + static_cast<double>(row) * (size.y + spacing), size.x, size.y},
            .size = size};
}

const Animation* Sheet::animation(std::string_view name) const {
    const auto at = std::find_if(animations.begin(), animations.end(),
                                 [&](const Animation& each) { return each.name == name; });
    return at == animations.end() ? nullptr : &*at;
}

Export read_export(std::string_view text) {
    FrameNames names;
    try {
        // An error in the text is that of `parse`.
        (void)json::sax_parse(text, &names);
        json document = json::parse(text);
        if (document.is_object() && document.contains("frames") && document["frames"].is_object()) {
            json frames = json::array();
            for (const std::string& name : names.all) frames.push_back(document["frames"][name]);
            document["frames"] = std::move(frames);
        }
        return read({document});
    } catch (const json::exception& error) {
        // It begins "[json.exception.parse_error.101] ".
        std::string why = error.what();
        if (const std::size_t end = why.find("] "); why.starts_with('[') && end != why.npos)
            why.erase(0, end + 2);
        throw std::runtime_error("is not a JSON export of Aseprite: " + why);
    }
}

}  // namespace fettle::visuals
