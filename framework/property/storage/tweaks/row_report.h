#pragma once
// What is told of rows that cannot be kept.

#include <string>

#include <fettle/property/storage/tweaks.h>

#include <tweaks/row_paths.h>

namespace fettle::property {

class RowReport {
  public:
    explicit RowReport(TweakReport& report) : report_(report) {}

    void tell(const JournalRow& row, const std::string& reason) {
        // What a file says of an instance begins at the top of its scene: "ball.mass: expected ..."
        const std::string path = path_of(row), about = reason.substr(0, reason.find(": "));
        const bool same = about.size() < reason.size() && path.ends_with(about);
        report_.problems.push_back(path + (same ? reason.substr(about.size()) : ": " + reason));
    }
    template <class Keep>
    bool tried(const JournalRow& row, Keep keep_it) {
        try {
            keep_it();
            return true;
        } catch (const SceneError& error) {
            tell(row, error.reason());  // the place is one in a text that nobody will see
        } catch (const Error& error) {
            tell(row, error.what());
        }
        return false;
    }
    /// The value to be kept.
    Image told(const JournalRow& row, const RowPaths& paths) {
        Image image = paths.live_image(row);
        if (image.kind == Image::Kind::formula && !image.not_saved.empty())
            report_.problems.push_back(path_of(row) + ": its formula " + image.not_saved +
                                       ", so its value is kept instead");
        return image;
    }

    /// Forgets what was told since there were `count` problems.
    std::size_t count() const { return report_.problems.size(); }
    void forget_since(std::size_t count) { report_.problems.resize(count); }

  private:
    TweakReport& report_;
};

}  // namespace fettle::property
