declare module "*.md" {
  const page: import("./pages").GuidePage;
  export default page;
}
