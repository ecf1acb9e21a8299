#pragma once
// A thread that copies a write-ahead log into its database file and synchronizes both with the
// disk. The thread of the game must not wait for the disk.

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>

namespace fettle::property {

class CheckpointThread {
  public:
    explicit CheckpointThread(std::filesystem::path file);
    /// Makes a last checkpoint.
    ~CheckpointThread();
    CheckpointThread(const CheckpointThread&) = delete;
    CheckpointThread& operator=(const CheckpointThread&) = delete;

    /// Must be called after a commit.
    void notify();

  private:
    void work();
    std::filesystem::path file_;
    std::mutex mutex_;
    std::condition_variable woken_;
    bool committed_ = false;
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace fettle::property
