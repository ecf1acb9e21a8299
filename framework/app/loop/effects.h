#pragma once
// The effect of a view: its file, and the values of its uniforms.

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fettle/app/effect.h>
#include <fettle/app/services.h>  // declares the class, which is not exported
#include <fettle/app/view.h>
#include <fettle/property/storage/assets.h>
#include <fettle/property/tree.h>

namespace fettle::app {

class Effects {
  public:
    /// Adds the class `Uniforms` and `view.uniforms`.
    Effects(property::Tree& tree, const View& view, property::Assets* assets);
    Effects(const Effects&) = delete;

    /// Reads the file if its name has changed. So a missing file is reported also if nothing is
    /// drawn.
    void step();
    /// The effect to draw now; null if there is none. `time`: s.
    const Effect* now(double time);
    /// To be called when the effect of `now` was drawn. `problem`: why it was not; "" if it was. If
    /// its code is in error, its uniforms are not reported: their declarations may be the error.
    void drawn(const std::string& problem);
    void on_problem(std::function<void(const std::string&)> report) { report_ = std::move(report); }
    /// Reads the file again before the next frame. If it cannot be read, the old code stays.
    void renew(const std::string& name);

  private:
    void read();
    void report(const std::string& problem);  // once
    void set_uniforms();

    property::Tree& tree_;
    const View& view_;
    property::Assets* assets_;
    Effect effect_{};
    bool readable_ = false;
    bool changed_ = false;                           // the file, since it was read
    std::vector<std::string> wrong_uniforms_{};      // problems
    std::map<std::string, std::string> declared_{};  // uniforms of the code with their types
    std::set<std::string> reported_{};
    std::function<void(const std::string&)> report_{};
};

/// The uniforms that a shader declares, with their types.
std::map<std::string, std::string> uniforms_in(const std::string& code);

}  // namespace fettle::app
