#include <draw/effect_pass.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <utility>

namespace fettle::app {

namespace {

constexpr const char* vertex_shader = R"(#version 120
varying vec2 point;
void main() {
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
    gl_FrontColor = gl_Color;
    point = gl_MultiTexCoord0.xy;
}
)";

// The rows of the copy of a window are from the bottom.
constexpr const char* declarations = R"(
uniform sampler2D fettle_picture;
uniform float fettle_flipped;
uniform vec2 size;
uniform float time;
varying vec2 point;
vec4 picture(vec2 at) {
    vec2 place = at / size;
    return texture2D(fettle_picture, vec2(place.x, mix(place.y, 1.0 - place.y, fettle_flipped)));
}
)";

constexpr std::string_view version_word = "#version";

/// The code of a game after the declarations of Fettle. If it has a `#version`, that becomes the
/// first line.
std::string whole(std::string code) {
    std::string version = "#version 120";
    const std::size_t at = code.find(version_word);
    if (at != std::string::npos && (at == 0 || code[at - 1] == '\n')) {
        const std::size_t end = std::min(code.find('\n', at), code.size());
        version = code.substr(at, end - at);
        std::fill(code.begin() + static_cast<std::ptrdiff_t>(at),
                  code.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    }
    // Since version 1.50, the number is that of the next line and not of this one.
    const bool newer = std::atoi(version.c_str() + version_word.size()) >= 150;
    return version + declarations + (newer ? "#line 1\n" : "#line 0\n") + code;
}

/// Collects the messages that SFML writes while this object exists.
class Messages {
  public:
    Messages() : before_(sf::err().rdbuf(text_.rdbuf())) {}
    ~Messages() { sf::err().rdbuf(before_); }
    Messages(const Messages&) = delete;
    std::string text() const { return text_.str(); }

  private:
    std::ostringstream text_;
    std::streambuf* before_;
};

/// The first error of a driver as "crt.frag:5: ...". Drivers write "0:5(12): error: ..." (Mesa),
/// "0(5) : error ..." or "ERROR: 0:5: ...".
std::string first_error(const std::string& name, const std::string& log) {
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t begin = line.starts_with("ERROR: ") ? 7 : 0;
        if (line.size() < begin + 3 || line[begin] != '0' ||
            (line[begin + 1] != ':' && line[begin + 1] != '('))
            continue;
        std::size_t end = begin + 2;
        while (end < line.size() && line[end] >= '0' && line[end] <= '9') ++end;
        std::string what = line.substr(std::min(line.size(), line.find(':', end)));
        const std::size_t text = what.find_first_not_of(": ");
        if (end == begin + 2 || text == std::string::npos) continue;
        what = what.substr(text);
        if (what.starts_with("error: ")) what = what.substr(7);
        return name + ":" + line.substr(begin + 2, end - begin - 2) + ": " + what;
    }
    return name + ": it cannot be compiled: " + log;
}

void set_uniform(sf::Shader& shader, const std::string& name, const property::Value& value,
                 const std::string& type) {
    const auto number = [&] { return static_cast<float>(value.as_double()); };
    if (type == "float") shader.setUniform(name, number());
    if (type == "int") shader.setUniform(name, static_cast<int>(number()));
    if (type == "bool") shader.setUniform(name, value.boolean());
    if (type == "vec2") {
        const property::Vec2& v = value.vec2();
        shader.setUniform(name, sf::Glsl::Vec2(static_cast<float>(v.x), static_cast<float>(v.y)));
    }
    if (type != "vec3" && type != "vec4") return;
    const property::Color c = value.color();
    if (type == "vec3")
        shader.setUniform(name, sf::Glsl::Vec3(c.r, c.g, c.b));
    else
        shader.setUniform(name, sf::Glsl::Vec4(c.r, c.g, c.b, c.a));
}

}  // namespace

std::string EffectPass::compile(const Effect& effect) {
    if (name_ == effect.name && code_ == effect.code) return problem_;
    if (name_ != effect.name) shader_.reset();
    name_ = effect.name;
    code_ = effect.code;
    auto made = std::make_unique<sf::Shader>();
    const Messages messages;
    const bool compiled = made->loadFromMemory(vertex_shader, whole(code_));
    problem_ = compiled ? "" : first_error(name_, messages.text());
    if (compiled) shader_ = std::move(made);
    return problem_;
}

std::string EffectPass::draw(sf::RenderTarget& target, const Effect& effect,
                             const std::function<bool(sf::Texture&)>& copy) {
    if (!sf::Shader::isAvailable())
        return effect.name + ": this computer draws without shaders, so the picture stays as it is";
    std::string problem = compile(effect);
    if (shader_ == nullptr) return problem;
    const sf::Vector2u size = target.getSize();
    if (picture_.getSize() != size && !sfml::create(picture_, size.x, size.y))
        return effect.name + ": there is no memory for a copy of the picture";
    picture_.setSmooth(true);
    const bool flipped = copy(picture_);
    const auto wide = static_cast<float>(size.x), high = static_cast<float>(size.y);
    const Messages ignored;  // uniforms that the driver found to be unused
    shader_->setUniform("fettle_picture", picture_);
    shader_->setUniform("fettle_flipped", flipped ? 1.0f : 0.0f);
    shader_->setUniform("size", sf::Glsl::Vec2(wide, high));
    shader_->setUniform("time", static_cast<float>(effect.time));
    for (const auto& [name, value, type] : effect.uniforms)
        set_uniform(*shader_, name, value, type);
    std::array<sf::Vertex, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
        corners[i].position = {i % 2 == 0 ? 0 : wide, i < 2 ? 0 : high};
        corners[i].texCoords = corners[i].position;
        corners[i].color = sf::Color::White;
    }
    target.setView(sf::View(sfml::rectangle(0, 0, wide, high)));
    sf::RenderStates states;
    states.blendMode = sf::BlendNone;
    states.shader = shader_.get();
    target.draw(corners.data(), corners.size(), sf::PrimitiveType::TriangleStrip, states);
    return problem;
}

}  // namespace fettle::app
