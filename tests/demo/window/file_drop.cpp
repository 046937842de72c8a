#include "tests/demo/window/file_drop.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>

namespace weft::demo {

struct FileDrop::Impl {
    std::string list;  // as text/uri-list
    Display* display = XOpenDisplay(nullptr);
    Window own = 0, target = 0;
    bool dropped = false, taken = false;

    [[nodiscard]] Atom atom(const char* name) const { return XInternAtom(display, name, False); }

    Window find(Window below, const std::string& title) const {
        char* name = nullptr;
        const bool named = XFetchName(display, below, &name) != 0;
        const bool is = named && title == name;
        if (named) XFree(name);
        if (is) return below;
        Window root = 0, parent = 0, *children = nullptr, found = 0;
        unsigned count = 0;
        if (XQueryTree(display, below, &root, &parent, &children, &count) == 0) return 0;
        for (unsigned k = 0; k < count && found == 0; ++k) found = find(children[k], title);
        if (children != nullptr) XFree(children);
        return found;
    }

    void tell(const char* what, long second, long third, long fourth, long fifth) const {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target;
        event.xclient.message_type = atom(what);
        event.xclient.format = 32;
        const long data[] = {static_cast<long>(own), second, third, fourth, fifth};
        for (int k = 0; k < 5; ++k) event.xclient.data.l[k] = data[k];
        XSendEvent(display, target, False, NoEventMask, &event);
    }

    void give(const XSelectionRequestEvent& asked) const {
        XChangeProperty(display, asked.requestor, asked.property, asked.target, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(list.data()), static_cast<int>(list.size()));
        XEvent answer{};
        answer.xselection.type = SelectionNotify;
        answer.xselection.requestor = asked.requestor;
        answer.xselection.selection = asked.selection;
        answer.xselection.target = asked.target;
        answer.xselection.property = asked.property;
        answer.xselection.time = asked.time;
        XSendEvent(display, asked.requestor, False, NoEventMask, &answer);
    }
};

FileDrop::FileDrop(std::string file, const std::string& title) : impl_(std::make_unique<Impl>()) {
    impl_->list = "file://" + std::move(file) + "\r\n";
    if (impl_->display == nullptr) return;
    const Window root = DefaultRootWindow(impl_->display);
    impl_->own = XCreateSimpleWindow(impl_->display, root, 0, 0, 1, 1, 0, 0, 0);
    impl_->target = impl_->find(root, title);
    XSetSelectionOwner(impl_->display, impl_->atom("XdndSelection"), impl_->own, CurrentTime);
    impl_->tell("XdndEnter", 5L << 24, static_cast<long>(impl_->atom("text/uri-list")), 0, 0);
    impl_->tell("XdndPosition", 0, (100L << 16) | 100, CurrentTime,
                static_cast<long>(impl_->atom("XdndActionCopy")));
    XSync(impl_->display, False);
}

FileDrop::~FileDrop() {
    if (impl_->display != nullptr) XCloseDisplay(impl_->display);
}

bool FileDrop::goes_on() {
    while (impl_->display != nullptr && XPending(impl_->display) > 0) {
        XEvent event;
        XNextEvent(impl_->display, &event);
        if (event.type == SelectionRequest) impl_->give(event.xselectionrequest);
        if (event.type != ClientMessage) continue;
        if (event.xclient.message_type == impl_->atom("XdndStatus") && !impl_->dropped) {
            impl_->dropped = true;
            impl_->tell("XdndDrop", 0, CurrentTime, 0, 0);
        }
        impl_->taken |= event.xclient.message_type == impl_->atom("XdndFinished");
    }
    if (impl_->display != nullptr) XFlush(impl_->display);
    return impl_->taken;
}

}  // namespace weft::demo
