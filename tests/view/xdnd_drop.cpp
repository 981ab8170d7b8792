// xdnd_drop WINDOW X Y PATH...: drops files on a place of an X window, as a file manager does (XDND, version 5). Exit
// status 0 once the window says that it has taken them.

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

namespace {

struct Source {
  Display* display = nullptr;
  Window own = 0, target = 0;
  Atom atom(const char* name) const { return XInternAtom(display, name, False); }
};

void send(const Source& s, const char* type, long a, long b = 0, long c = 0, long d = 0) {
  XEvent event = {};
  event.xclient.type = ClientMessage;
  event.xclient.display = s.display;
  event.xclient.window = s.target;
  event.xclient.message_type = s.atom(type);
  event.xclient.format = 32;
  const long data[] = {static_cast<long>(s.own), a, b, c, d};
  for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = data[i];
  XSendEvent(s.display, s.target, False, NoEventMask, &event);
  XFlush(s.display);
}

// "file:///a%20chair.glb", each with its line's end.
std::string uriList(int count, char** paths) {
  std::string list;
  for (int i = 0; i < count; ++i) {
    list += "file://";
    for (const char* c = paths[i]; *c != '\0'; ++c) {
      char text[4];
      const bool plain = (*c >= '0' && *c <= '9') || (*c >= 'A' && *c <= 'Z') || (*c >= 'a' && *c <= 'z') ||
                         *c == '/' || *c == '.' || *c == '-' || *c == '_';
      std::snprintf(text, sizeof text, plain ? "%c" : "%%%02X", static_cast<unsigned char>(*c));
      list += text;
    }
    list += "\r\n";
  }
  return list;
}

void answer(const Source& s, const XSelectionRequestEvent& request, const std::string& list) {
  XChangeProperty(s.display, request.requestor, request.property, request.target, 8, PropModeReplace,
                  reinterpret_cast<const unsigned char*>(list.data()), static_cast<int>(list.size()));
  XEvent event = {};
  event.xselection.type = SelectionNotify;
  event.xselection.requestor = request.requestor;
  event.xselection.selection = request.selection;
  event.xselection.target = request.target;
  event.xselection.property = request.property;
  event.xselection.time = request.time;
  XSendEvent(s.display, request.requestor, False, NoEventMask, &event);
  XFlush(s.display);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) return std::fputs("xdnd_drop WINDOW X Y PATH...\n", stderr), 2;
  Source s;
  s.display = XOpenDisplay(nullptr);
  if (s.display == nullptr) return std::fputs("no display\n", stderr), 2;
  s.target = std::strtoul(argv[1], nullptr, 0);
  const Window root = DefaultRootWindow(s.display);
  s.own = XCreateSimpleWindow(s.display, root, 0, 0, 1, 1, 0, 0, 0);
  XSetSelectionOwner(s.display, s.atom("XdndSelection"), s.own, CurrentTime);
  int x = 0, y = 0;
  Window child = 0;
  XTranslateCoordinates(s.display, s.target, root, std::atoi(argv[2]), std::atoi(argv[3]), &x, &y, &child);
  const std::string list = uriList(argc - 4, argv + 4);

  send(s, "XdndEnter", 5L << 24, static_cast<long>(s.atom("text/uri-list")));
  const auto place = [&] {
    send(s, "XdndPosition", 0, (static_cast<long>(x) << 16) | y, CurrentTime,
         static_cast<long>(s.atom("XdndActionCopy")));
  };
  place();
  bool dropped = false;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (std::chrono::steady_clock::now() < end) {
    if (XPending(s.display) == 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      continue;
    }
    XEvent event;
    XNextEvent(s.display, &event);
    if (event.type == SelectionRequest) answer(s, event.xselectionrequest, list);
    if (event.type != ClientMessage) continue;
    if (event.xclient.message_type == s.atom("XdndStatus") && !dropped) {
      if ((event.xclient.data.l[1] & 1) == 0) return std::fputs("the window refuses the drop\n", stderr), 1;
      send(s, "XdndDrop", 0, CurrentTime);
      dropped = true;
    }
    if (event.xclient.message_type == s.atom("XdndFinished"))
      // GLFW has a number of bytes where the protocol has a bit.
      return event.xclient.data.l[1] != 0 ? 0 : (std::fputs("the drop came to nothing\n", stderr), 1);
  }
  return std::fputs(dropped ? "the drop is never finished\n" : "the window says nothing of the drop\n", stderr), 1;
}
