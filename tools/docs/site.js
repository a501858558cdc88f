// The search from a disk, and the playground of the first page.

// A browser starts no worker from a disk. This one is a frame with the same script, which Material for MkDocs allows for by this name.
if (location.protocol === "file:")
    window.Worker = window.IFrameWorker = class extends EventTarget {
        constructor(address) {
            super();
            this.messages = [];
            const frame = document.createElement("iframe");
            frame.hidden = true;
            document.body.append(frame);
            const inside = (this.inside = frame.contentWindow);
            inside.postMessage = (data) => this.dispatchEvent(new MessageEvent("message", {data}));
            inside.document.write("<body></body>");   // at once, so that no empty page replaces it later
            inside.document.close();
            const script = inside.document.createElement("script");
            script.src = new URL(address, location);
            script.onload = () => {
                for (const data of this.messages.splice(0)) this.send(data);
                this.ready = true;
            };
            inside.document.body.append(script);
        }
        send(data) {
            this.inside.dispatchEvent(new MessageEvent("message", {data}));
        }
        postMessage(data) {
            if (this.ready) this.send(data);
            else this.messages.push(data);
        }
    };

// In a query a colon would end the name of a field: Wind::step is one word here.
__search.transform = (words) =>
    words.replace(/"|(?:^|\s+)[*+\-:^~]+(?=\s+|$)/g, " ").trim().replace(/:/g, "\\:");

// The playground is some megabytes: it is loaded where a reader asks for it.
document.addEventListener("click", (event) => {
    const button = event.target.closest(".play > a");
    if (!button || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const frame = document.createElement("iframe");
    frame.src = button.parentElement.dataset.play;
    frame.title = "A meadow in the wind";
    frame.allow = "fullscreen";
    button.parentElement.querySelector("img").replaceWith(frame);
    button.remove();
});
