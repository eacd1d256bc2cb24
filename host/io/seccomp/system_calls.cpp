#include "io/system_calls.hpp"

#include <cerrno>
#include <cstdint>
#include <memory>
#include <system_error>

#include <linux/sched.h>
#include <linux/seccomp.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace lineatlas {

namespace {

/// Refuses all system calls except the allowed ones.
class Filter {
  public:
    Filter() : context_(::seccomp_init(SCMP_ACT_ERRNO(EPERM)), ::seccomp_release) {
        if (!context_) check(-ENOMEM);
    }

    /// Allows a call if its arguments meet all conditions.
    template <class... Condition>
    void allow(int call, Condition... conditions) {
        rule(SCMP_ACT_ALLOW, call, conditions...);
    }

    template <class... Condition>
    void rule(std::uint32_t action, int call, Condition... conditions) {
        const int result =
            ::seccomp_rule_add(context_.get(), action, call, sizeof...(conditions), conditions...);
        if (result != -EDOM) check(result); // EDOM: this architecture has no such call
    }

    /// Loads the filter for all threads of this process.
    void load() {
        check(::seccomp_attr_set(context_.get(), SCMP_FLTATR_CTL_TSYNC, 1));
        check(::seccomp_load(context_.get()));
    }

  private:
    static void check(int result) {
        if (result < 0) throw std::system_error(-result, std::generic_category(), "seccomp");
    }

    std::unique_ptr<void, decltype(&::seccomp_release)> context_;
};

/// A condition on an argument, as SCMP_A0_64 and its kin make it, which are not valid C++.
scmp_arg_cmp argument(unsigned number, scmp_compare compare, scmp_datum_t a, scmp_datum_t b = 0) {
    return {number, compare, a, b};
}

void allow_descriptors(Filter& filter) {
    // Only on descriptors up to stderr. The process has no use for others.
    const scmp_arg_cmp standard = argument(0, SCMP_CMP_LE, STDERR_FILENO);
    for (const int call : {SCMP_SYS(read), SCMP_SYS(write), SCMP_SYS(writev), SCMP_SYS(recvfrom),
                           SCMP_SYS(sendto), SCMP_SYS(fstat), SCMP_SYS(lseek)})
        filter.allow(call, standard);
    filter.allow(SCMP_SYS(close));
}

void allow_memory(Filter& filter) {
    for (const int call : {SCMP_SYS(brk), SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(madvise)})
        filter.allow(call);
    // Memory that was written cannot be executed.
    const scmp_arg_cmp not_run = argument(2, SCMP_CMP_MASKED_EQ, PROT_EXEC, 0);
    for (const int call : {SCMP_SYS(mmap), SCMP_SYS(mmap2), SCMP_SYS(mprotect)})
        filter.allow(call, not_run);
}

/// Allows new threads of this process, but no new process.
void allow_threads(Filter& filter) {
    filter.allow(SCMP_SYS(clone), argument(0, SCMP_CMP_MASKED_EQ, CLONE_THREAD, CLONE_THREAD));
    // The flags of clone3 are in memory, where no filter sees them. The filter answers as an older
    // kernel would, so that the C library uses clone.
    filter.rule(SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3));
    for (const int call :
         {SCMP_SYS(futex), SCMP_SYS(futex_time64), SCMP_SYS(set_robust_list), SCMP_SYS(rseq),
          SCMP_SYS(sched_yield), SCMP_SYS(sched_getaffinity), SCMP_SYS(gettid), SCMP_SYS(getpid)})
        filter.allow(call);
}

void allow_clocks_and_chance(Filter& filter) {
    for (const int call :
         {SCMP_SYS(clock_gettime), SCMP_SYS(clock_gettime64), SCMP_SYS(clock_nanosleep),
          SCMP_SYS(gettimeofday), SCMP_SYS(time), SCMP_SYS(sysinfo), SCMP_SYS(getrandom)})
        filter.allow(call);
}

void allow_the_end(Filter& filter) {
    for (const int call :
         {SCMP_SYS(exit), SCMP_SYS(exit_group), SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask),
          SCMP_SYS(rt_sigreturn), SCMP_SYS(sigaltstack), SCMP_SYS(restart_syscall)})
        filter.allow(call);
    filter.allow(SCMP_SYS(tgkill),
                 argument(0, SCMP_CMP_EQ, static_cast<scmp_datum_t>(::getpid()))); // abort()
}

} // namespace

bool knows_seccomp() {
    return true;
}

bool has_seccomp() {
    const std::uint32_t action = SECCOMP_RET_ERRNO;
    return ::syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0;
}

void restrict_system_calls() {
    Filter filter;
    allow_descriptors(filter);
    allow_memory(filter);
    allow_threads(filter);
    allow_clocks_and_chance(filter);
    allow_the_end(filter);
    filter.load();
}

} // namespace lineatlas
