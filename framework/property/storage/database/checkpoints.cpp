#include <database/checkpoints.h>

#include <chrono>
#include <optional>
#include <utility>

#include <database/database.h>

namespace fettle::property {

// Commits within this time share a checkpoint.
constexpr std::chrono::milliseconds checkpoint_delay{500};

CheckpointThread::CheckpointThread(std::filesystem::path file)
    : file_(std::move(file)), thread_([this] { work(); }) {}

CheckpointThread::~CheckpointThread() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    woken_.notify_all();
    thread_.join();
}

void CheckpointThread::notify() {
    {
        const std::lock_guard lock(mutex_);
        committed_ = true;
    }
    woken_.notify_all();
}

void CheckpointThread::work() {
    std::optional<Database> database;
    std::unique_lock lock(mutex_);
    while (true) {
        woken_.wait(lock, [this] { return committed_ || ending_; });
        if (!ending_) woken_.wait_for(lock, checkpoint_delay, [this] { return ending_; });
        const bool last = ending_;
        const bool due = std::exchange(committed_, false);
        lock.unlock();
        try {
            if (due) {
                if (!database) {
                    database.emplace(file_, Access::existing);
                    database->run("PRAGMA synchronous = FULL");
                }
                // A passive checkpoint neither waits for other connections nor blocks them. The
                // next checkpoint copies what this one had to leave.
                database->run("PRAGMA wal_checkpoint(PASSIVE)");
            }
        } catch (const DatabaseError&) {
            // For example a full disk. The log keeps all data, and the owner gets the error from
            // its next write.
        }
        if (last) return;
        lock.lock();
    }
}

}  // namespace fettle::property
