#pragma once

namespace lineatlas {

/// A process that works for this one, at the other end of a stream socket. It ends with this
/// object, even in the middle of its work.
class WorkerProcess {
  public:
    WorkerProcess() = default; ///< none
    /// A child process, and this side's socket; both are owned from here on.
    WorkerProcess(int process, int socket) : process_(process), socket_(socket) {}
    ~WorkerProcess() { end(); }
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;
    WorkerProcess(WorkerProcess&& other) noexcept;
    WorkerProcess& operator=(WorkerProcess&& other) noexcept;

    bool is_there() const { return process_ > 0; }
    int id() const { return process_; }
    int socket() const { return socket_; }

    struct Ending {
        int status = 0;            ///< as waitpid() gives it
        bool went_on_mute = false; ///< it had nothing more to say and did not end: it was killed
    };
    /// How the process has ended, once nothing more comes from it. It is given a moment to do so.
    Ending ending();

    /// Kills the process; nothing that it could still do is wanted.
    void end();

  private:
    int process_ = -1;
    int socket_ = -1;
};

} // namespace lineatlas
