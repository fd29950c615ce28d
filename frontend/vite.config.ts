/// <reference types="vitest/config" />
import { defineConfig } from "vite";

/** Where `npm run dev` finds the server; the built front end is served by the server itself. */
const server = `http://127.0.0.1:${process.env.SIGHTLINE_PORT ?? "8000"}`;

export default defineConfig({
  // the catalogue of messages lies beside the server's code
  server: { fs: { allow: [".", "../backend/sightline/messages"] }, proxy: { "/api": server, "/openapi.json": server } },
  build: { target: "es2022", sourcemap: false, reportCompressedSize: true },
  test: {
    environment: "happy-dom",
    include: ["src/**/*.test.{ts,tsx}"],
    restoreMocks: true,
  },
});
