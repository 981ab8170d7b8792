#include "base/sandbox.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace facet {

namespace {

namespace fs = std::filesystem;

// ---- Files ----------------------------------------------------------------------------------------------------------

// Of linux/landlock.h, which older systems do not have, or not whole.
struct RulesetAttributes {
  uint64_t files, network;
};
struct [[gnu::packed]] PathAttributes {
  uint64_t allowed;
  int32_t parent;
};
constexpr long createRuleset = 444, addRule = 445, restrictSelf = 446;  // on all architectures
constexpr uint32_t askVersion = 1;
constexpr int pathBeneath = 1;
constexpr uint64_t writeFile = 1 << 1, readFile = 1 << 2, readFolder = 1 << 3, removeFolder = 1 << 4,
                   removeFile = 1 << 5, makeFolder = 1 << 7, makeFile = 1 << 8, truncateFile = 1 << 14,
                   allOfFirst = (1 << 13) - 1;
constexpr uint64_t network = 1 | 2;  // bind, connect

constexpr uint64_t execute = 1 << 0, reading = readFile | readFolder;
constexpr uint64_t writing = reading | writeFile | removeFile | makeFolder | makeFile | truncateFile;
constexpr uint64_t ofFiles = readFile | writeFile | truncateFile;

void allow(int ruleset, const fs::path& path, uint64_t rights) {
  const int fd = open(path.c_str(), O_PATH | O_CLOEXEC);
  if (fd < 0) return;
  struct stat status {};
  if (fstat(fd, &status) == 0) {
    const PathAttributes rule{S_ISDIR(status.st_mode) ? rights : rights & ofFiles, fd};
    syscall(addRule, ruleset, pathBeneath, &rule, 0);
  }
  close(fd);
}

std::string confineFiles(const Needed& needed) {
  const long version = syscall(createRuleset, nullptr, 0, askVersion);
  if (version < 1) return "no: the kernel has no landlock";
  uint64_t handled = version >= 3 ? allOfFirst | truncateFile : allOfFirst;
  if (needed.window) handled &= ~(reading | execute);
  const RulesetAttributes attributes{handled, network};
  const int ruleset = static_cast<int>(
      syscall(createRuleset, &attributes, version >= 4 ? sizeof attributes : sizeof attributes.files, 0));
  if (ruleset < 0) return std::string("no: ") + std::strerror(errno);
  if (!needed.window)
    for (const char* folder : {"/usr", "/lib", "/lib64", "/sys", "/proc/self"})
      allow(ruleset, folder, reading & handled);
  allow(ruleset, "/dev", (reading | writeFile | truncateFile) & handled);
  if (!needed.window)
    for (const fs::path& path : needed.read) allow(ruleset, path, reading & handled);
  for (const fs::path& path : needed.written)
    allow(ruleset, path, (needed.window ? writing | removeFolder : writing) & handled);
  const long done = syscall(restrictSelf, ruleset, 0);
  const int problem = errno;
  close(ruleset);
  return done == 0 ? "landlock " + std::to_string(version) : std::string("no: ") + std::strerror(problem);
}

// ---- Calls ----------------------------------------------------------------------------------------------------------

#if defined(__x86_64__)
constexpr uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr uint32_t architecture = AUDIT_ARCH_AARCH64;
#endif

#if (defined(__x86_64__) || defined(__aarch64__)) && !defined(__SANITIZE_ADDRESS__)

constexpr uint32_t sockets[] = {
    __NR_socket, __NR_socketpair, __NR_connect, __NR_bind, __NR_listen, __NR_accept, __NR_accept4,
};
constexpr uint32_t processes[] = {
    __NR_execve, __NR_execveat, __NR_kill,
#if defined(__x86_64__)
    __NR_fork,   __NR_vfork,
#endif
};
constexpr uint32_t refused[] = {
    // other processes
    __NR_ptrace,
    __NR_process_vm_readv,
    __NR_process_vm_writev,
    __NR_pidfd_open,
    __NR_pidfd_send_signal,
    438 /* pidfd_getfd */,
    __NR_tkill,
    __NR_rt_sigqueueinfo,
    __NR_rt_tgsigqueueinfo,
    // rights and owners of files by name, and other ways to files
    __NR_fchmodat,
    __NR_fchownat,
    __NR_setxattr,
    __NR_lsetxattr,
    __NR_removexattr,
    __NR_lremovexattr,
    __NR_truncate,
    __NR_open_by_handle_at,
    __NR_name_to_handle_at,
    425 /* io_uring_setup */,
    426 /* io_uring_enter */,
    427 /* io_uring_register */,
    // what system tools do
    __NR_mount,
    __NR_umount2,
    __NR_pivot_root,
    __NR_chroot,
    __NR_setns,
    __NR_unshare,
    __NR_bpf,
    __NR_perf_event_open,
    __NR_userfaultfd,
    __NR_keyctl,
    __NR_add_key,
    __NR_request_key,
    __NR_personality,
    __NR_kexec_load,
    __NR_init_module,
    __NR_finit_module,
    __NR_delete_module,
    __NR_reboot,
    __NR_swapon,
    __NR_swapoff,
    __NR_quotactl,
    __NR_acct,
    __NR_settimeofday,
    __NR_clock_settime,
    __NR_sethostname,
    __NR_setdomainname,
#if defined(__x86_64__)
    __NR_chmod,
    __NR_chown,
    __NR_lchown,
#endif
};

class Filter {
 public:
  explicit Filter(bool window) {
    load(offsetof(seccomp_data, arch));
    add(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0);
    add(BPF_RET | BPF_K, error(EPERM));
    load(offsetof(seccomp_data, nr));
#if defined(__x86_64__)
    add(BPF_JMP | BPF_JGE | BPF_K, 0x40000000, 0, 1);  // the calls of x32
    add(BPF_RET | BPF_K, error(EPERM));
#endif
    for (const uint32_t call : refused) answer(call, error(EPERM));
    if (window) {
      refuseOtherSockets();
    } else {
      for (const uint32_t call : sockets) answer(call, error(EPERM));
      for (const uint32_t call : processes) answer(call, error(EPERM));
    }
    answer(435, error(ENOSYS));  // clone3, whose flags cannot be looked at: the C library then calls clone
    if (!window) refuseProcesses();
    add(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  }

  // 0, or what went wrong.
  int install() {
    const sock_fprog program{static_cast<unsigned short>(code_.size()), code_.data()};
    if (syscall(__NR_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program) == 0) return 0;
    return errno == 0 ? EBUSY : errno;
  }

 private:
  static uint32_t error(int code) { return SECCOMP_RET_ERRNO | static_cast<uint32_t>(code); }
  void add(int code, uint32_t value, uint8_t ifTrue = 0, uint8_t ifFalse = 0) {
    code_.push_back({static_cast<uint16_t>(code), ifTrue, ifFalse, value});
  }
  void load(size_t offset) { add(BPF_LD | BPF_W | BPF_ABS, static_cast<uint32_t>(offset)); }
  void refuseProcesses() {
    add(BPF_JMP | BPF_JEQ | BPF_K, __NR_clone, 0, 4);
    load(offsetof(seccomp_data, args));
    add(BPF_JMP | BPF_JSET | BPF_K, CLONE_THREAD, 1, 0);
    add(BPF_RET | BPF_K, error(EPERM));
    load(offsetof(seccomp_data, nr));
    // Signals to threads of this process alone.
    add(BPF_JMP | BPF_JEQ | BPF_K, __NR_tgkill, 0, 4);
    load(offsetof(seccomp_data, args));
    add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<uint32_t>(getpid()), 1, 0);
    add(BPF_RET | BPF_K, error(EPERM));
    load(offsetof(seccomp_data, nr));
  }
  // Whatever is connected or bound was made by this call.
  void refuseOtherSockets() {
    add(BPF_JMP | BPF_JEQ | BPF_K, __NR_socket, 0, 4);
    load(offsetof(seccomp_data, args));
    add(BPF_JMP | BPF_JEQ | BPF_K, AF_UNIX, 1, 0);
    add(BPF_RET | BPF_K, error(EPERM));
    load(offsetof(seccomp_data, nr));
  }
  void answer(uint32_t call, uint32_t result) {
    add(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 1);
    add(BPF_RET | BPF_K, result);
  }

  std::vector<sock_filter> code_;
};

std::string confineCalls(const Needed& needed) {
  const int problem = Filter(needed.window).install();
  return problem == 0 ? "seccomp" : std::string("no: ") + std::strerror(problem);
}

#else

std::string confineCalls(const Needed&) { return "no: not on this architecture, nor with sanitizers"; }

#endif

}  // namespace

Confined confineProcess(const Needed& needed) {
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return {"no: the kernel refuses", "no: the kernel refuses"};
  Confined out;
  out.files = confineFiles(needed);
  out.calls = confineCalls(needed);
  return out;
}

}  // namespace facet
