#pragma once
// The part of a runtime in a snapshot: state of the random numbers, timers, and instances that are
// stepped. Variables of the game and running coroutines are not included and stay as they are.

#include <fettle/property/snapshot.h>

#include <handlers/timers.h>

namespace fettle::script {

struct Machine;

class RuntimePart : public property::SnapshotPart {
  public:
    static constexpr std::string_view name = "scripts";
    explicit RuntimePart(Machine& machine) : machine_(machine) {}

    std::string_view part_name() const override { return name; }
    property::Memory save(property::ByteWriter& to) const override;
    std::function<void()> restore(property::ByteReader& from,
                                  const property::Memory& memory) override;
    property::Memory changes() override;
    void redo(const property::Memory& changes) override;
    std::size_t size_of(const property::Memory& memory) const override;
    std::vector<std::string> remarks() const override;

  private:
    std::vector<std::string> lost_handlers() const;

    Machine& machine_;
    /// After a restore from a file: the instances that had handlers when the file was saved. Empty
    /// after a restore from memory.
    std::vector<property::Handle> had_handlers_;
    /// After a restore from a file: the timers that it ended, and the coroutines that waited when
    /// it was saved.
    Timers::Places ended_timers_, coroutines_;
};

}  // namespace fettle::script
