// SPDX-License-Identifier: Apache-2.0
// The connection to the server.
import { decode, type Message, otherVersion } from "./protocol.ts";

export interface Link {
  send(command: Uint8Array): void;
  readonly open: boolean;
}

/** Why a message is invalid, and the cure. */
function objection(bytes: Uint8Array): string {
  const other = otherVersion(bytes);
  if (!other) return "The program sent a message that this page does not understand: reload the page.";
  return other.older
    ? `This page ${other.text} than the program: reload the page; if that does not help, build it again.`
    : `This page ${other.text} than the program: end hapticut view, and start the one that was built with the page.`;
}

/**
 * @param token  from the address that the program has printed
 * @param heard  called with each message
 * @param lost   called with a text for the user when the connection has ended
 */
export function connect(token: string, heard: (message: Message) => void, lost: (text: string) => void): Link {
  let socket: WebSocket, ever = false, heardAny = false, objected = false;
  const close = (event: CloseEvent) => {
    if (objected) return;
    if (heardAny && event.code !== 1008) return open(); // reconnect, for example after the machine has slept
    lost(!ever
      ? "The server refuses this page: open the address that the program has printed, with its token."
      : event.code === 1008
        ? "The server has disconnected this page because of an invalid message: reload the page."
        : "The program has ended, or the connection is lost: start hapticut view again, and open the printed address.");
  };
  const receive = (event: MessageEvent) => {
    if (objected) return;
    const bytes = new Uint8Array(event.data as ArrayBuffer), message = decode(bytes);
    heardAny = true;
    if (message) return heard(message);
    objected = true;
    socket.close();
    lost(objection(bytes));
  };
  const open = () => {
    heardAny = false;
    socket = new WebSocket(`ws://${location.host}/socket?token=${encodeURIComponent(token)}`);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => { ever = true; };
    socket.onclose = close;
    socket.onmessage = receive;
  };
  open();
  return {
    send: (command) => { if (socket.readyState === WebSocket.OPEN) socket.send(command); },
    get open() { return socket.readyState === WebSocket.OPEN; },
  };
}
