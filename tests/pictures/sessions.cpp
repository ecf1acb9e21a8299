#include "sessions.h"

#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include "play.h"

namespace fettle::pictures {

namespace {

class Reader {
  public:
    Reader(std::filesystem::path project, std::filesystem::path frames)
        : project_(std::move(project)), frames_(std::move(frames)) {}

    void command(const std::string& line) {
        rest_.clear();
        rest_.str(line);
        const std::string name = word();
        if (name == "game") {
            game_ = project_ / word();
        } else if (name == "size") {
            width_ = static_cast<unsigned>(number());
            height_ = static_cast<unsigned>(number());
        } else if (name == "prepare") {
            prepare_ += text() + "\n";
        } else {
            play(name);
        }
    }
    int frames() const { return play_ ? play_->frames() : 0; }
    void save(const std::filesystem::path& picture) {
        if (play_) play_->save(picture);
    }

  private:
    void play(const std::string& name) {
        if (!play_) play_.emplace(game_, prepare_, width_, height_, frames_);
        if (name == "wait") {
            play_->wait(number());
        } else if (name == "move" || name == "click") {
            const float x = number(), y = number(), seconds = number();
            play_->move(x, y, seconds);
            if (name == "move") return;
            play_->press();
            play_->release();
        } else if (name == "press") {
            play_->press();
        } else if (name == "release") {
            play_->release();
        } else if (name == "key") {
            play_->key(word());
        } else if (name == "type") {
            play_->type(text());
        } else if (name == "expect") {
            play_->expect(text());
        } else {
            throw std::runtime_error("no such command: " + name);
        }
    }

    std::string word() {
        std::string found;
        if (!(rest_ >> found)) throw std::runtime_error("a word is missing");
        return found;
    }
    float number() {
        float found = 0;
        if (!(rest_ >> found)) throw std::runtime_error("a number is missing");
        return found;
    }
    std::string text() {
        std::string found;
        std::getline(rest_ >> std::ws, found);
        return found;
    }

    std::filesystem::path project_, frames_, game_;
    std::string prepare_;
    unsigned width_ = 960, height_ = 600;
    std::istringstream rest_;
    std::optional<Play> play_;
};

}  // namespace

int play_session(const std::filesystem::path& session, const std::filesystem::path& project,
                 const std::filesystem::path& frames) {
    std::ifstream file(session);
    if (!file) throw std::runtime_error(session.string() + ": there is no such session");
    Reader reader(project, frames);
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        if (line.empty() || line[0] == '#') continue;
        try {
            reader.command(line);
        } catch (const std::exception& error) {
            throw std::runtime_error(session.string() + ":" + std::to_string(number) + ": " +
                                     error.what());
        }
    }
    if (is_picture(frames)) reader.save(frames);
    return reader.frames();
}

}  // namespace fettle::pictures
