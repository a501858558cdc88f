// Files from the page's server, with an end to waiting: a server that sends nothing for a while is as one that is gone.
// [ms] Tests wait for less.
export const patience = () => self.windrowPatience ?? 15000;

export const nameOf = (address) => address.split("/").pop();
export async function fetchBytes(address) {
    const stop = new AbortController();
    let timer = 0;
    const wait = () => {
        clearTimeout(timer);
        timer = setTimeout(() => stop.abort(), patience());
    };
    try {
        wait();
        const answer = await fetch(address, {signal: stop.signal});
        if (!answer.ok) throw new Error(`${nameOf(address)}: the server answered ${answer.status}`);
        const parts = [];
        for (const reader = answer.body.getReader(); ; ) {
            wait();
            const {done, value} = await reader.read();
            if (done) break;
            parts.push(value);
        }
        return await new Blob(parts).arrayBuffer();
    } catch (fault) {
        throw fault.message.startsWith(nameOf(address)) ? fault : new Error(`${nameOf(address)}: the server does not answer`);
    } finally {
        clearTimeout(timer);
    }
}
