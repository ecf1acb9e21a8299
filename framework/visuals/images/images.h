#pragma once
// The image files of a game, each loaded once and shared.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <fettle/property/media.h>
#include <fettle/property/storage/assets.h>
#include <fettle/property/storage/saves.h>

#include <images/sheet.h>

namespace fettle::visuals {

class Images {
  public:
    explicit Images(property::Assets* assets) : assets_(assets) {}

    /// The file of that name; the checkerboard if it is missing or cannot be read.
    std::shared_ptr<const Sheet> get(const property::FileUser& user, const std::string& name);
    /// From now on, the pixels of a file that have this color are not seen; nullopt: all are.
    void make_transparent(const std::string& name, const std::optional<property::Color>& color);
    /// Gives the picture of a saved game, which `get` returns for "save:SLOT".
    using SavedPicture = std::function<property::Thumbnail(const std::string& slot)>;
    void saved_pictures(SavedPicture of) { saved_ = std::move(of); }
    /// Reads the file again, and the sheets that it belongs to. If that fails, they stay.
    void renew(const std::string& name);
    /// Reports a problem, once. Problems before `on_problem` are kept, and reported by it.
    void report(const std::string& problem);
    /// The same for a problem that many instances have: `problem` begins with the path of the first
    /// that has it, and is made only for that one.
    void report_once(const std::string& what, const std::function<std::string()>& problem);
    void on_problem(std::function<void(const std::string&)> listener);
    property::Assets* assets() const { return assets_; }

    std::optional<bool> smooth{};  // of enlarged images; empty: by class

  private:
    void read_saved(Sheet& into, const std::string& slot) const;
    void read(Sheet& into, const std::string& what, const std::string& name) const;
    std::shared_ptr<Sheet> load(const property::FileUser& user, const std::string& name);

    property::Assets* assets_;
    std::map<std::string, std::shared_ptr<Sheet>> sheets_;
    std::map<std::string, property::Color> transparent_;  // by file
    std::map<std::string, std::string> reported_;         // the problem of each key
    std::function<void(const std::string&)> report_;
    SavedPicture saved_;
};

}  // namespace fettle::visuals
