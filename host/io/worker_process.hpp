#pragma once

namespace lineatlas {

/// A process that works for this one, at the other end of a stream socket. It ends with this
/// object, even in the middle of its work.
class WorkerProcess {
  public:
    WorkerProcess() = default; ///< none
    /// Takes over a child process and this side's socket.
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
        int status = 0;            ///< as waitpid() returns it
        bool went_on_mute = false; ///< it said no more but did not end, and was killed
    };
    /// How the process has ended. Call when nothing more comes from it. Gives the process a moment
    /// to end.
    Ending ending();

    /// Kills the process.
    void end();

  private:
    int process_ = -1;
    int socket_ = -1;
};

} // namespace lineatlas
