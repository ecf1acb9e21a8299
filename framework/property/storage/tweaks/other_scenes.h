#pragma once
// What scene files say of instances by their paths from the root: of those of other files and of
// those that a script makes. A keep changes it where it changes these.

#include <filesystem>
#include <map>
#include <optional>

#include <fettle/property/storage/tweaks.h>

#include <scenes/scene_edit.h>
#include <tweaks/tweaks_state.h>

namespace fettle::property {

class OtherScenes {
  public:
    /// Reads the scene files that were loaded when one of them may have to be changed. What is
    /// wrong with one is told.
    OtherScenes(Tweaks::State& state, TweakReport& report) : state_(state), report_(report) {}

    /// What names the deleted instance names nothing; the row remembers what it was.
    void forget(const JournalRow& deletion);
    void put_back(const JournalRow& restoration);
    /// In all of them but one, which has the new names already.
    void rename(const InstanceMoves& moves, const std::filesystem::path& except);
    /// Those that have another text now.
    void write();

  private:
    struct Text {
        std::string now, before;
    };
    std::map<std::filesystem::path, Text>& texts();
    template <class Change>
    void change(const std::filesystem::path& file, Text& text, Change change);

    Tweaks::State& state_;
    TweakReport& report_;
    std::optional<std::map<std::filesystem::path, Text>> texts_;
};

}  // namespace fettle::property
