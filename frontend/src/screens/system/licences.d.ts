declare module "virtual:licences" {
  const found: readonly { name: string; version: string; licence: string | null }[];
  export default found;
}
