#pragma once
// The image files of a game, each loaded once and shared.

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

#include <fettle/property/storage/assets.h>

#include <images/sheet.h>

namespace fettle::visuals {

class Images {
  public:
    explicit Images(property::Assets* assets) : assets_(assets) {}

    /// The file of that name; the checkerboard if it is missing or cannot be read. `what` begins
    /// the message about that: "Sprite.image".
    std::shared_ptr<const Sheet> get(const std::string& what, const std::string& name);
    /// Reads the file again, and the sheets that it belongs to. If that fails, they stay.
    void renew(const std::string& name);
    /// Tells a problem, once. Before `on_problem` it is kept.
    void tell(const std::string& problem);
    void on_problem(std::function<void(const std::string&)> tell);
    property::Assets* assets() const { return assets_; }

  private:
    void read(Sheet& into, const std::string& what, const std::string& name) const;
    std::shared_ptr<Sheet> load(const std::string& what, const std::string& name);

    property::Assets* assets_;
    std::map<std::string, std::shared_ptr<Sheet>> sheets_;
    std::set<std::string> told_;
    std::function<void(const std::string&)> tell_;
};

}  // namespace fettle::visuals
