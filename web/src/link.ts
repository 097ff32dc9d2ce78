// SPDX-License-Identifier: Apache-2.0
// Where messages come from: the server, or a recording that lies in the page or beside it.
import { decode, type Message } from "./protocol.ts";

export interface Link {
  send(command: Uint8Array): void;
  readonly open: boolean;
}

/** @param token  of the address that the program has printed */
export function connect(token: string, heard: (message: Message) => void, state: (text: string, open: boolean) => void): Link {
  const socket = new WebSocket(`ws://${location.host}/socket?token=${encodeURIComponent(token)}`);
  socket.binaryType = "arraybuffer";
  let ever = false;
  socket.onopen = () => {
    ever = true;
    state("connected", true);
  };
  socket.onclose = (event) => {
    const why = !ever
      ? "The server refuses this page: open the address that the program has printed, with its token."
      : event.code === 1008
        ? "The server has closed this page, because it sent what it may not. Reload it."
        : "The program has ended, or the line is broken. Start hapticut view again, and open what it prints.";
    state(why, false);
  };
  socket.onmessage = (event) => {
    const message = decode(new Uint8Array(event.data as ArrayBuffer));
    if (message) heard(message);
    else state("The server speaks another version of the protocol: reload the page, or build it anew.", true);
  };
  return {
    send: (command) => { if (socket.readyState === WebSocket.OPEN) socket.send(command); },
    get open() { return socket.readyState === WebSocket.OPEN; },
  };
}
